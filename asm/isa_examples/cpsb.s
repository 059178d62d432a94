        .include "vectors.s"
        .regs   r16, a, c, z, n
        bits    a, "1010"
        bits    z, "1011"
        bits    c, "0000"
        CPSB    [a], [c] ? [z]
        LTOR    c, n
        EXIT
; expect-bits: [c.bits] = 1100
; expect: n = 3
