        .include "vectors.s"
        .regs   r16, a, index, value, d
        words   a, 1.0, -2.0, 3.0, 4.5
        MAXV    [a], index, value
        MAXV    |[a]|, r20, r0          ; only the index
        halves  d, 1.0, -2.0, 3.0, 4.5  ; operands of 32 bits
        MAXV,H  [d], r21, h60           ; value in a half of r30
        EXIT
; expect: index = 3
; expect: value = 4.5
; expect: r20 = 3
; expect: h60 = 4.5
; expect: r21 = 3
