; ADDN: T := normalised(R + S)

        .include "scalar.inc"

        two     plain, ADDN, 1.5, 2.25
; expect: [plain] = 3.75

        two     mixed, ADDN, 10.0, -0.5
; expect: [mixed] = 9.5

        two     equal, ADDN, 3.0, 3.0
; expect: [equal] = 6.0

        two     opposite, ADDN, 3.0, -3.0
; expect: [opposite] = 0.0

; unnormalised: integers
        two     integers, ADDN, 5, 3
; expect: [integers] = 8.0

; coefficient overflow
        two     carry, ADDN, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [carry] = X'0001 7FFF FFFF FFFF'

; a tiny negative operand counts: results are cut by floor
        two     under, ADDN, 1.0, X'FFA2 8000 0000 0000'
; expect: [under] = X'FFD1 7FFF FFFF FFFF'

; shifted out of the register altogether
        two     far, ADDN, 1.0, X'F000 8000 0000 0000'
; expect: [far] = X'FFD1 7FFF FFFF FFFF'

; inexact
        two     tenth, ADDN, 0.1, 0.2
; expect: [tenth] = X'FFD0 4CCC CCCC CCCC'

; its exponent counts in the alignment
        two     zero_coefficient, ADDN, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = 1.0

; machine zero leaves the other operand
        two     zero_left, ADDN, 0.0, 7
; expect: [zero_left] = 7.0

        two     zero_right, ADDN, -1.5, 0.0
; expect: [zero_right] = -1.5

        two     zero_both, ADDN, 0.0, 0.0
; expect: [zero_both] = 0.0

        two     indefinite, ADDN, 1.0, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, ADDN, X'6FFF 7FFF FFFF FFFF', X'6FFF 8000 0000 0000'
; expect: [overflow] = X'6FD0 8000 0000 0000'

        two     huge, ADDN, X'6FFF 7FFF FFFF FFFF', X'6FFF 7FFF FFFF FFFF'
; expect: [huge] = X'7000 0000 0000 0000'

        two     underflow, ADDN, X'9000 4000 0000 0001', X'9000 4000 0000 0000'
; expect: [underflow] = X'9001 4000 0000 0000'

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        ADDN    r0, left, result
        keep    zero_first
; expect: [zero_first] = -2.5
        ADDN    left, r0, result
        keep    zero_second
; expect: [zero_second] = -2.5
        ADDN    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
