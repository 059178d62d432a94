        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 7, 6, 9, 8
        words   b, 2, 4, 3, 1
        words   c
        DIVUV   [a], [b], [c]
        EXIT
; expect: [c.words] = 3.5, 1.5, 3.0, 8.0
