        ES      r10, 3
        ES      r11, -4
        ADJE    r10, r11, r12
        EXIT
; expect: r12 = X'FFFC 0000 0000 0030'
