; A sum over one broadcast number has no length.
        ES      r11, 7
        SUMV    r10, r11
; expect-trap: bad-descriptor
; expect: r11 = 7
