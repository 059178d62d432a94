        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 4.0, 2.0, 1.0, 4.0
        bits    c, "0000"
        CMPGEV  [a], [b], [c]
        .regs   r19, d, e               ; operands of 32 bits
        halves  d, 1.0, 2.0, 3.0, 4.0
        bits    e, "0000"
        load_half h60, 3.0, r9
        CMPGEV,H [d], h60, [e]
        EXIT
; expect-bits: [c.bits] = 0111
; expect-bits: [e.bits] = 0011
