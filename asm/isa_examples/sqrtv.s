        .include "vectors.s"
        .regs   r16, a, c
        words   a, 2.25, 4.0, 9.0, 0.0
        words   c
        SQRTV   [a], [c]
        EXIT
; expect: [c.words] = 1.5, 2.0, 3.0, 0.0
