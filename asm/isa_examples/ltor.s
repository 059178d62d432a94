        EX      r10, 0x800000
        ELEN    r10, 4
        LTOR    r10, r11
        EXIT
; expect: r11 = 4
