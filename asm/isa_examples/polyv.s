        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 0.0, 1.0, 2.0, -1.0
        words   b, 2.0, 0.0, -1.0, 3.0  ; 2 x^3 - x + 3
        words   c
        POLYV   [a], [b], [c]
        EXIT
; expect: [c.words] = 3.0, 4.0, 17.0, 2.0
