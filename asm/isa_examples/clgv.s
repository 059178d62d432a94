        .include "vectors.s"
        .regs   r16, a, c
        words   a, 2.75, -2.75, 3, 0.5
        words   c
        CLGV    [a], [c]
        EXIT
; expect: [c.words] = 3, -2, 3, 1
