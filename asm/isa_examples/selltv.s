        .include "vectors.s"
        .regs   r16, a, b, first
        words   a, 5.0, 2.0, 3.0, 3.5
        words   b, 4.0, 2.0, 1.0, 4.0
        SELLTV  [a], [b], first
        EXIT
; expect: first = 3
