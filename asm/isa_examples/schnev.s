        .include "vectors.s"
        .regs   r16, a, b, c
        words   a, 1.0, 2.0, 3.0, 4.0
        words   b, 1.0, 1.0, 2.0, 2.0
        words   c
        SCHNEV  [a], [b], [c]
        EXIT
; expect: [c.words] = 2, 0, 0, 0
