        .include "vectors.s"
        .regs   r16, a, b, upper, lower, d, e
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        DOTV    [a], [b], upper         ; lower is the next register
        ADDN    upper, r0, upper        ; normalised
        ADDN    upper, lower, upper     ; sum of the two parts
        halves  d, 1.0, -2.0, 3.0, 4.5  ; operands of 32 bits
        halves  e, 10.0, 0.5, -3.0, 1.5
        DOTV,H  [d], [e], h60
        ADDNH   h60, h0, h60
        ADDNH   h60, h61, h60
        EXIT
; expect: upper = 6.75
; expect: h60 = 6.75
