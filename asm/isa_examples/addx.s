        EX      r10, 0x800000
        ELEN    r10, 4
        ES      r11, 64                 ; adds a word
        ADDX    r10, r11, r12
        EXIT
; expect: r12 = X'0004 0000 0080 0040'
