; ADDLEN: T := R with its length field increased by S

        .regs   r10, vector, by, longer, shorter, wrapped
        .regs   r20, less, high

        EX      vector, X'FFFF 0000 0040'
        ELEN    vector, 100
        ES      by, 5
        ADDLEN  vector, by, longer
; expect: r12 = X'0069 FFFF 0000 0040'

        EX      less, -30
        ADDLEN  vector, less, shorter
; expect: r13 = X'0046 FFFF 0000 0040'

; 16 bits: the length wraps, the address stays
        EX      by, 65535
        ADDLEN  vector, by, wrapped
; expect: r14 = X'0063 FFFF 0000 0040'

        ADDLEN  vector, by, r0
; expect: r0 = 0

        EXIT
