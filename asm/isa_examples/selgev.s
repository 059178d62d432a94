        .include "vectors.s"
        .regs   r16, a, b, first
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 4.0, 2.0, 1.0, 4.0
        SELGEV  [a], [b], first
        EXIT
; expect: first = 1
