; EXH: R := I24, as an integer

        EXH     h20, 5
        EXH     h21, -1                 ; the left half stays
; expect: h20 = 5
; expect: r10 = X'0000 0005 00FF FFFF'
        EXH     h22, X'FF FFFF'
        EXH     h23, 0x800000
; expect: r11 = X'00FF FFFF 0080 0000'
        EXH     h24, -0x800000
; expect: h24 = X'0080 0000'
        EXH     h255, 9
; expect: r127 = X'0000 0000 0000 0009'
        EXH     h0, 7                   ; both are constants
        EXH     h1, 7
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
