        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        words   c
        ADDUV   [a], [b], [c]
        EXIT
; expect: [c.words] = 11.0, -1.5, X'FFD3 0000 0000 0000', 6.0
