        ES      r10, -46
        EX      r11, 1 << 46
        PACK    r10, r11, r12
        EXIT
; expect: r12 = 1.0
