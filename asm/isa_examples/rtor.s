        ES      r10, 5
        RTOR    r10, r11
        EXIT
; expect: r11 = 5
