        .include "vectors.s"
        .regs   r16, a, value, index
        words   a, 1.0, -2.0, 3.0, 4.5
        MAXV    [a], value              ; index is the register after value
        .reg    d, r19                  ; the same of 32 bits
        halves  d, 1.0, -2.0, 3.0, 4.5
        MAXV,H  [d], h60                ; the value in a half of r30
        EXIT
; expect: value = 4.5
; expect: index = 3
; expect: h60 = 4.5
; expect: r61 = 3
