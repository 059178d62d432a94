        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 12, 12, 0, -1
        words   b, 10, 3, 5, 5
        words   c
        ANDV    [a], [b], [c]
        EXIT
; expect: [c.words] = 8, 0, 0, 5
