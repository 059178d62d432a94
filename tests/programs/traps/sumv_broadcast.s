; A sum over one broadcast number has no length.
        ES      r11, 7
        .half   X'DA10 000A', X'0000 000B' ; SUMV r10, r11
; expect-trap: bad-descriptor
; expect: r11 = 7
