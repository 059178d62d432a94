; Where both sources are broadcast, there is no length.
        ES      r11, 7
        SELEQV  r10, r10, r11
; expect-trap: bad-descriptor
; expect: r11 = 7
