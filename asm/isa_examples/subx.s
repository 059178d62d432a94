        ES      r10, 4
        ES      r11, 7
        SUBX    r10, r11, r12
        EXIT
; expect: r12 = -3
