        .include "vectors.s"
        .regs   r16, a, d, upper, lower
        words   a, 1.0, -2.0, 3.0, 4.5
        SUMV    [a], upper              ; lower is the next register
        ADDN    upper, r0, upper        ; normalised
        ADDN    upper, lower, upper     ; sum of the two parts
        halves  d, 1.0, -2.0, 3.0, 4.5  ; operands of 32 bits
        SUMV,H  [d], h60
        ADDNH   h60, h0, h60
        ADDNH   h60, h61, h60
        EXIT
; expect: upper = 6.5
; expect: h60 = 6.5
