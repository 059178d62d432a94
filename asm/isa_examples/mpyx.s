        ES      r10, 4
        ES      r11, -7
        MPYX    r10, r11, r12
        EXIT
; expect: r12 = -28
