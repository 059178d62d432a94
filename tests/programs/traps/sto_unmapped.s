; A store to page 0, which is never mapped.
        ES      r11, 7
        STO     [r0], r11
; expect-trap: unmapped-address
