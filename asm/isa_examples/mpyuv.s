        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, -2.0
        words   b, 10.0, 0.5
        words   c
        MPYUV   [a], [b], [c]
        EXIT
; expect: [c.words] = X'FFD6 2800 0000 0000', X'FFD2 C000 0000 0000'
