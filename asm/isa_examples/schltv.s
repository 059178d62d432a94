        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 4.0, 4.0, 1.0, 9.0
        words   c
        SCHLTV  [a], [b], [c]
        EXIT
; expect: [c.words] = 0, 0, 0, 3
