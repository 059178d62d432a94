; PACK: T := low 16 bits of R as exponent, coefficient of S

        .include "scalar.inc"

        two     plain, PACK, -46, X'0000 4000 0000 0000'
; expect: [plain] = 1.0

        two     other_exponent, PACK, 3, 1.0
; expect: [other_exponent] = X'0003 4000 0000 0000'

        two     low_bits, PACK, X'1234 0000 0001 8000', X'5678 0000 0000 0007'
; expect: [low_bits] = X'8000 0000 0000 0007'

        two     negative, PACK, 28671, -1
; expect: [negative] = X'6FFF FFFF FFFF FFFF'

; no word is special here, and no flag set
        two     indefinite, PACK, X'7000 0000 0000 7000', X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

        PACK    left, r0, result        ; register 0 is 0
        keep    register_zero
; expect: [register_zero] = X'7000 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
