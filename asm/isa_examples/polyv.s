        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 0.0, 1.0, 2.0, -1.0
        words   b, 2.0, 0.0, -1.0, 3.0  ; 2 x^3 - x + 3
        words   c
        POLYV   [a], [b], [c]
        .regs   r19, d, e, f            ; operands of 32 bits
        halves  d, 0.0, 1.0, 2.0, -1.0
        halves  e, 2.0, 0.0, -1.0, 3.0
        halves  f
        POLYV,H [d], [e], [f]
        EXIT
; expect: [c.words] = 3.0, 4.0, 17.0, 2.0
; expect-halves: [f.halves] = 3.0, 4.0, 17.0, 2.0
