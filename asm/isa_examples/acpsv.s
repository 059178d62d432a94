        .include "vectors.s"
        .regs   r16, a, b, c, z, n
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 2.0, 2.0, 2.0, 2.0
        words   c
        bits    z, "0000"
        ACPSV   [a], [b], [c], [z]
        LTOR    c, n
        EXIT
; expect: [c.words] = 3.0, 4.5, 0, 0
; expect-bits: [z.bits] = 0011
; expect: n = 2
