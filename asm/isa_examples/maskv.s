        .include "vectors.s"
        .regs   r16, a, b, c, z
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 11.0, 12.0, 13.0, 14.0
        words   c
        bits    z, "1001"
        MASKV   [a], [b], [c] ? [z]
        EXIT
; expect: [c.words] = 1.0, 12.0, 13.0, 4.0
