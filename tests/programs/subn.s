; SUBN: T := normalised(R - S)

        .include "scalar.inc"

        two     plain, SUBN, 1.5, 2.25
; expect: [plain] = -0.75

        two     mixed, SUBN, 10.0, -0.5
; expect: [mixed] = 10.5

        two     equal, SUBN, 3.0, 3.0
; expect: [equal] = 0.0

        two     opposite, SUBN, 3.0, -3.0
; expect: [opposite] = 6.0

; unnormalised: integers
        two     integers, SUBN, 5, 3
; expect: [integers] = 2.0

; coefficient overflow
        two     carry, SUBN, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [carry] = 0.0

; a tiny negative operand counts: results are cut by floor
        two     under, SUBN, 1.0, X'FFA2 8000 0000 0000'
; expect: [under] = 1.0

; shifted out of the register altogether
        two     far, SUBN, 1.0, X'F000 8000 0000 0000'
; expect: [far] = 1.0

; inexact
        two     tenth, SUBN, 0.1, 0.2
; expect: [tenth] = X'FFCE 9999 9999 999A'

; its exponent counts in the alignment
        two     zero_coefficient, SUBN, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = 1.0

; machine zero leaves the other operand
        two     zero_left, SUBN, 0.0, 7
; expect: [zero_left] = -7.0

        two     zero_right, SUBN, -1.5, 0.0
; expect: [zero_right] = -1.5

        two     zero_both, SUBN, 0.0, 0.0
; expect: [zero_both] = 0.0

        two     indefinite, SUBN, 1.0, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, SUBN, X'6FFF 7FFF FFFF FFFF', X'6FFF 8000 0000 0000'
; expect: [overflow] = X'7000 0000 0000 0000'

        two     huge, SUBN, X'6FFF 7FFF FFFF FFFF', X'6FFF 7FFF FFFF FFFF'
; expect: [huge] = 0.0

        two     underflow, SUBN, X'9000 4000 0000 0001', X'9000 4000 0000 0000'
; expect: [underflow] = 0.0

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        SUBN    r0, left, result
        keep    zero_first
; expect: [zero_first] = 2.5
        SUBN    left, r0, result
        keep    zero_second
; expect: [zero_second] = -2.5
        SUBN    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
