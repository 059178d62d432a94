; DIVUH: T := upper(R / S)

        .include "half.inc"

        two     plain, DIVUH, 3.0, 2.0
; expect-halves: [plain] = 1.5

        two     mixed, DIVUH, -0.5, 10.0
; expect-halves: [mixed] = X'E599 999A'

; unnormalised: integers
        two     integers, DIVUH, 42, 6
; expect-halves: [integers] = 7.0

; inexact: towards zero
        two     third, DIVUH, 1.0, 3.0
; expect-halves: [third] = X'E855 5555'

        two     minus_third, DIVUH, -1.0, 3.0
; expect-halves: [minus_third] = X'E8AA AAAB'

; as significant as the less significant operand
        two     less_significant, DIVUH, 0.1, 5
; expect-halves: [less_significant] = X'E451 EB84'

        two     small, DIVUH, 1, X'007F FFFF'
; expect-halves: [small] = X'E900 0001'

        two     zero_dividend, DIVUH, 0.0, 7
; expect-halves: [zero_dividend] = 0.0

        two     no_coefficient, DIVUH, X'1000 0000', 2.0
; expect-halves: [no_coefficient] = X'0E00 0000'

; divide fault
        two     by_zero, DIVUH, 1.0, 0.0
; expect-halves: [by_zero] = X'7000 0000'

        two     by_zero_coefficient, DIVUH, 1.0, X'1000 0000'
; expect-halves: [by_zero_coefficient] = X'7000 0000'

        two     zero_by_zero, DIVUH, 0.0, 0.0
; expect-halves: [zero_by_zero] = X'7000 0000'

        two     indefinite, DIVUH, X'7000 0000', 1.0
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, DIVUH, X'6F7F FFFF', 0.125
; expect-halves: [overflow] = X'7000 0000'

        two     underflow, DIVUH, X'9040 0000', 4.0
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        DIVUH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = 0.0
        DIVUH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = X'7000 0000'
        DIVUH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0072 0000'
