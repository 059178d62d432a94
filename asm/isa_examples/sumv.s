        .include "vectors.s"
        .regs   r16, a, c
        words   a, 1.0, -2.0, 3.0, 4.5
        SUMV    [a], c
        .reg    d, r18                  ; the same of 32 bits
        halves  d, 1.0, -2.0, 3.0, 4.5
        SUMV,H  [d], h60
        EXIT
; expect: c = 6.5
; expect: h60 = 6.5
