        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        words   c
        AVGV    [a], [b], [c]
        EXIT
; expect: [c.words] = 5.5, -0.75, 0.0, 3.0
