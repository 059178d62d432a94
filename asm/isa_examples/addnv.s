        .include "vectors.s"
        .regs   r16, a, b, c, z
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        words   c
        bits    z, "1011"
        ADDNV   [a], [b], [c] ? [z]
        .regs   r20, d, e               ; operands of 32 bits
        halves  d, 1.0, -2.0, 3.0, 4.5
        halves  e
        load_half h60, 0.5, r9
        ADDNV,H [d], h60, [e] ? [z]
        EXIT
; expect: [c.words] = 11.0, 0, 0.0, 6.0
; expect-halves: [e.halves] = 1.5, 0, 3.5, 5.0
