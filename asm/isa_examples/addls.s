        .include "vectors.s"
        .regs   r16, a, b, c, x, y, z
        words   a, 1.0, 1.0
        bits    x, "101"
        words   b, X'FFA0 4000 0000 0000'   ; 2 to the -50
        bits    y, "100"
        words   c
        bits    z, "000"
        ADDLS   [a, x], [b, y], [c], [z]
        EXIT
; expect: [c.words] = X'FFA3 0800 0000 0000', X'FFA3 0000 0000 0000'
; expect-bits: [z.bits] = 101
