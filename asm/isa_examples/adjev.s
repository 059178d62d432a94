        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 3, 1.0, 8
        words   b, -4, 0, 1
        words   c
        ADJEV   [a], [b], [c]
        EXIT
; expect: [c.words] = X'FFFC 0000 0000 0030', 1, X'0001 0000 0000 0004'
