        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 3, 1.0, 5, 3
        words   b, 4, -4, 0, 63
        words   c
        ADJSV   [a], [b], [c]
        EXIT
; expect: [c.words] = X'FFFC 0000 0000 0030', X'FFD6 0400 0000 0000', 5, 3.0
