        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, -46, -45, 0, 0
        words   b, 1 << 46, 1 << 46, 7, -1
        words   c
        PACKV   [a], [b], [c]
        EXIT
; expect: [c.words] = 1.0, 2.0, 7, -1
