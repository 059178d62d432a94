        .include "vectors.s"
        .regs   r16, a, c
        halves  a, 1.0, -2.0, 3.0, 5
        words   c
        EXTV    [a], [c]
        EXIT
; expect: [c.words] = 1.0, -2.0, 3.0, X'FFE8 0000 0500 0000'
