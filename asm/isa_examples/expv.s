        .include "vectors.s"
        .regs   r16, a, c
        words   a, 1.0, 2.0, 5, 0.125
        words   c
        EXPV    [a], [c]
        EXIT
; expect: [c.words] = -46, -45, 0, -49
