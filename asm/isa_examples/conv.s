        .include "vectors.s"
        .regs   r16, a, c
        words   a, 1.0, -2.0, 0.3, 5
        halves  c
        CONV    [a], [c]
        EXIT
; expect-halves: [c.halves] = 1.0, -2.0, X'E84C CCCC', X'1800 0000'
