        .include "vectors.s"
        .regs   r16, a, one, c
        words   a, 1.0, -2.0, 3.0, 4.5
        words   c
        load_constant one, 1.0
        SUBNV   -|[a]|, one, [c]
        EXIT
; expect: [c.words] = -2.0, -3.0, -4.0, -5.5
