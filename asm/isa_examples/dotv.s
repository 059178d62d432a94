        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        DOTV    [a], [b], c
        EXIT
; expect: c = 6.75
