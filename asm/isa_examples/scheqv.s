        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 4.0, 2.0, 1.0, 9.0
        words   c
        SCHEQV  [a], [b], [c]
        EXIT
; expect: [c.words] = 2, 1, 4, 0
