; ADDNH: T := normalised(R + S)

        .include "half.inc"

        two     plain, ADDNH, 1.5, 2.25
; expect-halves: [plain] = 3.75

        two     mixed, ADDNH, 10.0, -0.5
; expect-halves: [mixed] = 9.5

        two     equal, ADDNH, 3.0, 3.0
; expect-halves: [equal] = 6.0

        two     opposite, ADDNH, 3.0, -3.0
; expect-halves: [opposite] = 0.0

; unnormalised: integers
        two     integers, ADDNH, 5, 3
; expect-halves: [integers] = 8.0

; coefficient overflow
        two     carry, ADDNH, X'007F FFFF', X'007F FFFF'
; expect-halves: [carry] = X'017F FFFF'

; a tiny negative operand counts: results are cut by floor
        two     under, ADDNH, 1.0, X'D280 0000'
; expect-halves: [under] = X'E97F FFFF'

; shifted out of the register altogether
        two     far, ADDNH, 1.0, X'9080 0000'
; expect-halves: [far] = X'E97F FFFF'

; inexact
        two     tenth, ADDNH, 0.1, 0.2
; expect-halves: [tenth] = X'E84C CCCC'

; its exponent counts in the alignment
        two     zero_coefficient, ADDNH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = 1.0

; machine zero leaves the other operand
        two     zero_left, ADDNH, 0.0, 7
; expect-halves: [zero_left] = 7.0

        two     zero_right, ADDNH, -1.5, 0.0
; expect-halves: [zero_right] = -1.5

        two     zero_both, ADDNH, 0.0, 0.0
; expect-halves: [zero_both] = 0.0

        two     indefinite, ADDNH, 1.0, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, ADDNH, X'6F7F FFFF', X'6F80 0000'
; expect-halves: [overflow] = X'5880 0000'

        two     huge, ADDNH, X'6F7F FFFF', X'6F7F FFFF'
; expect-halves: [huge] = X'7000 0000'

        two     underflow, ADDNH, X'9040 0001', X'9040 0000'
; expect-halves: [underflow] = X'9140 0000'

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        ADDNH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = -2.5
        ADDNH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = -2.5
        ADDNH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
