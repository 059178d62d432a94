; LTOR: T := length field of R, as an integer

        .regs   r10, vector, length, longest, none

        EX      vector, X'FFFF 0000 0040'
        ELEN    vector, 100
        LTOR    vector, length
; expect: r11 = 100

        ELEN    vector, 65535
        LTOR    vector, longest
; expect: r12 = 65535

        LTOR    r0, none
; expect: r13 = 0

        EXIT
