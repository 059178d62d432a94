        .include "vectors.s"
        .regs   r16, a, b, c, factor
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        words   c
        load_constant factor, 2.0
        LINKV                           ; c := 2 a + b
        MPYSV   [a], factor, [c]
        ADDNV   [c], [b], [c]
        EXIT
; expect: [c.words] = 12.0, -3.5, 3.0, 10.5
