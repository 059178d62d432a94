        .include "vectors.s"
        .regs   r16, a, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   c
        ELEN    c, 3
        DELTAV  [a], [c]
        EXIT
; expect: [c.words] = -3.0, 5.0, 1.5, 0
