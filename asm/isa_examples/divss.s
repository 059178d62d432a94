        .include "vectors.s"
        .regs   r16, a, b, c, x, y, z
        words   a, 1.0, 2.0, 3.0
        bits    x, "11010"
        words   b, 4.0, 5.0
        bits    y, "01001"
        words   c
        bits    z, "00000"
        DIVSS   [a, x], [b, y], [c], [z]
        EXIT
; expect: [c.words] = 0.5, 0
; expect-bits: [z.bits] = 01000
