        ES      r10, 12
        ES      r11, 10
        XOR     r10, r11, r12
        EXIT
; expect: r12 = 6
