        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        words   c
        AVGDV   [a], [b], [c]
        EXIT
; expect: [c.words] = -4.5, -1.25, 3.0, 1.5
