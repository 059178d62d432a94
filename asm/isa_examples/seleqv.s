        .include "vectors.s"
        .regs   r16, a, b, first
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 4.0, 2.0, 1.0, 4.0
        SELEQV  [a], [b], first
        .regs   r19, d, last            ; operands of 32 bits
        halves  d, 1.0, 2.0, 3.0, 4.0
        load_half h60, 4.0, r9
        SELEQV,H [d], h60, last
        EXIT
; expect: first = 1
; expect: last = 3
