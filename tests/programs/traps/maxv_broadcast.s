; The greatest of one broadcast number has no length.
        ES      r11, 7
        .half   X'D810 000A', X'000C 000B' ; MAXV r10, r12, r11
; expect-trap: bad-descriptor
; expect: r11 = 7
; expect: r12 = 0
