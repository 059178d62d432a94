; SUBNH: T := normalised(R - S)

        .include "half.inc"

        two     plain, SUBNH, 1.5, 2.25
; expect-halves: [plain] = -0.75

        two     mixed, SUBNH, 10.0, -0.5
; expect-halves: [mixed] = 10.5

        two     equal, SUBNH, 3.0, 3.0
; expect-halves: [equal] = 0.0

        two     opposite, SUBNH, 3.0, -3.0
; expect-halves: [opposite] = 6.0

; unnormalised: integers
        two     integers, SUBNH, 5, 3
; expect-halves: [integers] = 2.0

; coefficient overflow
        two     carry, SUBNH, X'007F FFFF', X'007F FFFF'
; expect-halves: [carry] = 0.0

; a tiny negative operand counts: results are cut by floor
        two     under, SUBNH, 1.0, X'D280 0000'
; expect-halves: [under] = 1.0

; shifted out of the register altogether
        two     far, SUBNH, 1.0, X'9080 0000'
; expect-halves: [far] = 1.0

; inexact
        two     tenth, SUBNH, 0.1, 0.2
; expect-halves: [tenth] = X'E699 999A'

; its exponent counts in the alignment
        two     zero_coefficient, SUBNH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = 1.0

; machine zero leaves the other operand
        two     zero_left, SUBNH, 0.0, 7
; expect-halves: [zero_left] = -7.0

        two     zero_right, SUBNH, -1.5, 0.0
; expect-halves: [zero_right] = -1.5

        two     zero_both, SUBNH, 0.0, 0.0
; expect-halves: [zero_both] = 0.0

        two     indefinite, SUBNH, 1.0, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, SUBNH, X'6F7F FFFF', X'6F80 0000'
; expect-halves: [overflow] = X'7000 0000'

        two     huge, SUBNH, X'6F7F FFFF', X'6F7F FFFF'
; expect-halves: [huge] = 0.0

        two     underflow, SUBNH, X'9040 0001', X'9040 0000'
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        SUBNH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = 2.5
        SUBNH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = -2.5
        SUBNH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
