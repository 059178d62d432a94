        .include "vectors.s"
        .regs   r16, a, b, c, x, y, z
        words   a, 3, 6, 5
        bits    x, "11010"
        words   b, 4, 2
        bits    y, "01001"
        words   c
        bits    z, "00000"
        DIVUS   [a, x], [b, y], [c], [z]
        EXIT
; expect: [c.words] = 1.5, 0
; expect-bits: [z.bits] = 01000
