        .include "vectors.s"
        .regs   r16, a, c
        words   a, 1.0, -2.0, 3.0, 4.5
        SUMV    [a], c
        EXIT
; expect: c = 6.5
