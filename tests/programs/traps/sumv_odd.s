; A sum in two registers begins with an even one.
        ES      r10, 1
        .half   X'DA00 000A', X'0000 000B' ; SUMV [r10], r11
        ES      r10, 2
; expect-trap: undefined-instruction
; expect: r10 = 1
; expect: r11 = 0
; expect-warning: unset-length
