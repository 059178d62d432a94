        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, -0.5, 3.0, 4.5
        words   b, 0.1, 2.0, -3.0, 1.5
        words   c
        DIVSV   [a], [b], [c]
        EXIT
; expect: [c.words] = 10.0, -0.25, -1.0, 3.0
