        .include "vectors.s"
        .regs   r16, a, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   c
        ELEN    c, 3
        ADJMV   [a], [c]
        EXIT
; expect: [c.words] = -0.5, 0.5, 3.75, 0
