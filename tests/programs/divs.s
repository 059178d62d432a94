; DIVS: T := significant(R / S)

        .include "scalar.inc"

        two     plain, DIVS, 3.0, 2.0
; expect: [plain] = 1.5

        two     mixed, DIVS, -0.5, 10.0
; expect: [mixed] = X'FFCD 9999 9999 999A'

; unnormalised: integers
        two     integers, DIVS, 42, 6
; expect: [integers] = 7

; inexact: towards zero
        two     third, DIVS, 1.0, 3.0
; expect: [third] = X'FFD0 5555 5555 5555'

        two     minus_third, DIVS, -1.0, 3.0
; expect: [minus_third] = X'FFD0 AAAA AAAA AAAB'

; as significant as the less significant operand
        two     less_significant, DIVS, 0.1, 5
; expect: [less_significant] = X'FFF8 0000 0000 0005'

        two     small, DIVS, 1, X'0000 7FFF FFFF FFFF'
; expect: [small] = X'FFD1 0000 0000 0001'

        two     zero_dividend, DIVS, 0.0, 7
; expect: [zero_dividend] = 0.0

        two     no_coefficient, DIVS, X'0010 0000 0000 0000', 2.0
; expect: [no_coefficient] = 0.0

; divide fault
        two     by_zero, DIVS, 1.0, 0.0
; expect: [by_zero] = X'7000 0000 0000 0000'

        two     by_zero_coefficient, DIVS, 1.0, X'0010 0000 0000 0000'
; expect: [by_zero_coefficient] = X'7000 0000 0000 0000'

        two     zero_by_zero, DIVS, 0.0, 0.0
; expect: [zero_by_zero] = X'7000 0000 0000 0000'

        two     indefinite, DIVS, X'7000 0000 0000 0000', 1.0
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, DIVS, X'6FFF 7FFF FFFF FFFF', 0.125
; expect: [overflow] = X'7000 0000 0000 0000'

        two     underflow, DIVS, X'9000 4000 0000 0000', 4.0
; expect: [underflow] = 0.0

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        DIVS    r0, left, result
        keep    zero_first
; expect: [zero_first] = 0.0
        DIVS    left, r0, result
        keep    zero_second
; expect: [zero_second] = X'7000 0000 0000 0000'
        DIVS    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0072 0000'
; expect-warning: integer-operand
