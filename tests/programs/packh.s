; PACKH: T := low 8 bits of R as exponent, coefficient of S

        .include "half.inc"

        two     plain, PACKH, -22, X'0040 0000'
; expect-halves: [plain] = 1.0

        two     other_exponent, PACKH, 3, 1.0
; expect-halves: [other_exponent] = X'0340 0000'

        two     low_bits, PACKH, X'1234 5680', X'5600 0007'
; expect-halves: [low_bits] = X'8000 0007'

        two     negative, PACKH, 111, -1
; expect-halves: [negative] = X'6FFF FFFF'

; no word is special here, and no flag set
        two     indefinite, PACKH, X'7000 0070', X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

        PACKH   left, h0, result        ; register 0 is 0
        keep    register_zero
; expect-halves: [register_zero] = X'7000 0000'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
