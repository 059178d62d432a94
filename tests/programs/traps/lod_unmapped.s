; A load from page 0, which is never mapped, changes no register.
        ES      r10, 64
        ES      r11, 7
        LOD     [r10], r11
        ES      r11, 8
; expect-trap: unmapped-address
; expect: r11 = 7
