        .include "vectors.s"
        .regs   r16, a, b, c, z
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        words   c
        bits    z, "1011"
        ADDNV   [a], [b], [c] ? [z]
        EXIT
; expect: [c.words] = 11.0, 0, 0.0, 6.0
