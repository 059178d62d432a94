; SUBUH: T := upper(R - S)

        .include "half.inc"

        two     plain, SUBUH, 1.5, 2.25
; expect-halves: [plain] = X'EBE8 0000'

        two     mixed, SUBUH, 10.0, -0.5
; expect-halves: [mixed] = 10.5

        two     equal, SUBUH, 3.0, 3.0
; expect-halves: [equal] = X'EB00 0000'

        two     opposite, SUBUH, 3.0, -3.0
; expect-halves: [opposite] = 6.0

; unnormalised: integers
        two     integers, SUBUH, 5, 3
; expect-halves: [integers] = 2

; coefficient overflow
        two     carry, SUBUH, X'007F FFFF', X'007F FFFF'
; expect-halves: [carry] = 0

; a tiny negative operand counts: results are cut by floor
        two     under, SUBUH, 1.0, X'D280 0000'
; expect-halves: [under] = 1.0

; shifted out of the register altogether
        two     far, SUBUH, 1.0, X'9080 0000'
; expect-halves: [far] = 1.0

; inexact
        two     tenth, SUBUH, 0.1, 0.2
; expect-halves: [tenth] = X'E7CC CCCD'

; its exponent counts in the alignment
        two     zero_coefficient, SUBUH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = X'1000 0000'

; machine zero leaves the other operand
        two     zero_left, SUBUH, 0.0, 7
; expect-halves: [zero_left] = -7

        two     zero_right, SUBUH, -1.5, 0.0
; expect-halves: [zero_right] = -1.5

        two     zero_both, SUBUH, 0.0, 0.0
; expect-halves: [zero_both] = 0.0

        two     indefinite, SUBUH, 1.0, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, SUBUH, X'6F7F FFFF', X'6F80 0000'
; expect-halves: [overflow] = X'7000 0000'

        two     huge, SUBUH, X'6F7F FFFF', X'6F7F FFFF'
; expect-halves: [huge] = X'6F00 0000'

        two     underflow, SUBUH, X'9040 0001', X'9040 0000'
; expect-halves: [underflow] = X'9000 0001'

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        SUBUH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = 2.5
        SUBUH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = -2.5
        SUBUH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
