        .include "vectors.s"
        .regs   r16, a, c
        words   a, 1.0, -2.0, 0.3, 4.5
        halves  c
        RCONV   [a], [c]
        EXIT
; expect-halves: [c.halves] = 1.0, -2.0, X'E84C CCCD', 4.5
