        .include "vectors.s"
        .regs   r16, a, b, c
        bits    a, "0011"
        bits    b, "0101"
        bits    c, "0000"
        ANDB    [a], [b], [c]
        EXIT
; expect-bits: [c.bits] = 0001
