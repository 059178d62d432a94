; DIVSH: T := significant(R / S)

        .include "half.inc"

        two     plain, DIVSH, 3.0, 2.0
; expect-halves: [plain] = 1.5

        two     mixed, DIVSH, -0.5, 10.0
; expect-halves: [mixed] = X'E599 999A'

; unnormalised: integers
        two     integers, DIVSH, 42, 6
; expect-halves: [integers] = 7

; inexact: towards zero
        two     third, DIVSH, 1.0, 3.0
; expect-halves: [third] = X'E855 5555'

        two     minus_third, DIVSH, -1.0, 3.0
; expect-halves: [minus_third] = X'E8AA AAAB'

; as significant as the less significant operand
        two     less_significant, DIVSH, 0.1, 5
; expect-halves: [less_significant] = X'F800 0005'

        two     small, DIVSH, 1, X'007F FFFF'
; expect-halves: [small] = X'E900 0001'

        two     zero_dividend, DIVSH, 0.0, 7
; expect-halves: [zero_dividend] = 0.0

        two     no_coefficient, DIVSH, X'1000 0000', 2.0
; expect-halves: [no_coefficient] = 0.0

; divide fault
        two     by_zero, DIVSH, 1.0, 0.0
; expect-halves: [by_zero] = X'7000 0000'

        two     by_zero_coefficient, DIVSH, 1.0, X'1000 0000'
; expect-halves: [by_zero_coefficient] = X'7000 0000'

        two     zero_by_zero, DIVSH, 0.0, 0.0
; expect-halves: [zero_by_zero] = X'7000 0000'

        two     indefinite, DIVSH, X'7000 0000', 1.0
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, DIVSH, X'6F7F FFFF', 0.125
; expect-halves: [overflow] = X'7000 0000'

        two     underflow, DIVSH, X'9040 0000', 4.0
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        DIVSH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = 0.0
        DIVSH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = X'7000 0000'
        DIVSH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0072 0000'
; expect-warning: integer-operand
