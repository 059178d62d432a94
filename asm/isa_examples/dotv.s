        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        DOTV    [a], [b], c
        .regs   r19, d, e               ; the same of 32 bits
        halves  d, 1.0, -2.0, 3.0, 4.5
        halves  e, 10.0, 0.5, -3.0, 1.5
        DOTV,H  [d], [e], h60
        EXIT
; expect: c = 6.75
; expect: h60 = 6.75
