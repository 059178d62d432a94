; Page 0 has no memory.
        EX      r10, 32
        EXH     h22, 7
        LODH    [r10], h22
; expect-trap: unmapped-address
; expect: h22 = 7
