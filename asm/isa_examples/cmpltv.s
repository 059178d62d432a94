        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 4.0, 2.0, 1.0, 4.0
        bits    c, "0000"
        CMPLTV  [a], [b], [c]
        EXIT
; expect-bits: [c.bits] = 1000
