        CLOCK   r10
        ES      r12, 1
        CLOCK   r11
        SUBX    r11, r10, r12
        EXIT
; expect: r12 = 2
