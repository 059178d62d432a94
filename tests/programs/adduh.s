; ADDUH: T := upper(R + S)

        .include "half.inc"

        two     plain, ADDUH, 1.5, 2.25
; expect-halves: [plain] = 3.75

        two     mixed, ADDUH, 10.0, -0.5
; expect-halves: [mixed] = 9.5

        two     equal, ADDUH, 3.0, 3.0
; expect-halves: [equal] = 6.0

        two     opposite, ADDUH, 3.0, -3.0
; expect-halves: [opposite] = X'EB00 0000'

; unnormalised: integers
        two     integers, ADDUH, 5, 3
; expect-halves: [integers] = 8

; coefficient overflow
        two     carry, ADDUH, X'007F FFFF', X'007F FFFF'
; expect-halves: [carry] = X'017F FFFF'

; a tiny negative operand counts: results are cut by floor
        two     under, ADDUH, 1.0, X'D280 0000'
; expect-halves: [under] = X'EA3F FFFF'

; shifted out of the register altogether
        two     far, ADDUH, 1.0, X'9080 0000'
; expect-halves: [far] = X'EA3F FFFF'

; inexact
        two     tenth, ADDUH, 0.1, 0.2
; expect-halves: [tenth] = X'E84C CCCC'

; its exponent counts in the alignment
        two     zero_coefficient, ADDUH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = X'1000 0000'

; machine zero leaves the other operand
        two     zero_left, ADDUH, 0.0, 7
; expect-halves: [zero_left] = 7

        two     zero_right, ADDUH, -1.5, 0.0
; expect-halves: [zero_right] = -1.5

        two     zero_both, ADDUH, 0.0, 0.0
; expect-halves: [zero_both] = 0.0

        two     indefinite, ADDUH, 1.0, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, ADDUH, X'6F7F FFFF', X'6F80 0000'
; expect-halves: [overflow] = X'6FFF FFFF'

        two     huge, ADDUH, X'6F7F FFFF', X'6F7F FFFF'
; expect-halves: [huge] = X'7000 0000'

        two     underflow, ADDUH, X'9040 0001', X'9040 0000'
; expect-halves: [underflow] = X'9140 0000'

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        ADDUH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = -2.5
        ADDUH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = -2.5
        ADDUH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
