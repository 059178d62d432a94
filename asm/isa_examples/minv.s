        .include "vectors.s"
        .regs   r16, a, value, index
        words   a, 1.0, -2.0, 3.0, 4.5
        MINV    [a], value           ; index is the register after value
        EXIT
; expect: value = -2.0
; expect: index = 1
