        .include "vectors.s"
        .regs   r16, a, c, b
        words   a, 1.0, 1.0, 1.0, 1.0
        words   c
        load_constant b, X'FFA0 4000 0000 0000' ; 2 to the -50
        SUBLV   [a], b, [c]
        EXIT
; expect: [c.words] = X'FFA3 7800 0000 0000'
