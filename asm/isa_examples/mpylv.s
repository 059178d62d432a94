        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 3, 6, -2, 0
        words   b, 5, 7, -3, 4
        words   c
        MPYLV   [a], [b], [c]
        EXIT
; expect: [c.words] = 15, 42, 6, 0
