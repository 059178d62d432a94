        .include "vectors.s"
        .regs   r16, a, index, value
        words   a, 1.0, -2.0, 3.0, 4.5
        MINV    [a], index, value
        EXIT
; expect: index = 1
; expect: value = -2.0
