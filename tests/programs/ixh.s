; IXH: low 24 bits of R += I24

        .include "half.inc"

        EXH     h20, 5
        IXH     h20, 300
        EXH     h21, 5
        IXH     h21, -6
; expect: h20 = 305
; expect: h21 = -1
        EXH     h22, X'FF FFFF'
        IXH     h22, 2
; expect: r11 = X'0000 0001 0000 0000'
; the high 8 bits stay, and take no carry
        fetch   left, X'0AFF FFFF'
        IXH     left, 1
; expect: left = X'0A00 0000'
        IXH     h0, 1
        IXH     h1, 1
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
