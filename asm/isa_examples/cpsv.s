        .include "vectors.s"
        .regs   r16, a, c, z, n
        words   a, 1.0, 2.0, 3.0, 4.0
        words   c
        bits    z, "1011"
        CPSV    [a], [c] ? [z]
        LTOR    c, n
        .regs   r20, d, e               ; operands of 32 bits
        halves  d, 1.0, 2.0, 3.0, 4.0
        halves  e
        CPSV,H  [d], [e] ? [z]
        EXIT
; expect: [c.words] = 1.0, 3.0, 4.0, 0
; expect: n = 3
; expect-halves: [e.halves] = 1.0, 3.0, 4.0, 0
