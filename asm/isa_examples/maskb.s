        .include "vectors.s"
        .regs   r16, a, b, c, z
        bits    a, "1100"
        bits    b, "0011"
        bits    z, "1011"
        bits    c, "0000"
        MASKB   [a], [b], [c] ? [z]
        EXIT
; expect-bits: [c.bits] = 1000
