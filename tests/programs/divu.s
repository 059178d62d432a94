; DIVU: T := upper(R / S)

        .include "scalar.inc"

        two     plain, DIVU, 3.0, 2.0
; expect: [plain] = 1.5

        two     mixed, DIVU, -0.5, 10.0
; expect: [mixed] = X'FFCD 9999 9999 999A'

; unnormalised: integers
        two     integers, DIVU, 42, 6
; expect: [integers] = 7.0

; inexact: towards zero
        two     third, DIVU, 1.0, 3.0
; expect: [third] = X'FFD0 5555 5555 5555'

        two     minus_third, DIVU, -1.0, 3.0
; expect: [minus_third] = X'FFD0 AAAA AAAA AAAB'

; as significant as the less significant operand
        two     less_significant, DIVU, 0.1, 5
; expect: [less_significant] = X'FFCC 51EB 851E B851'

        two     small, DIVU, 1, X'0000 7FFF FFFF FFFF'
; expect: [small] = X'FFD1 0000 0000 0001'

        two     zero_dividend, DIVU, 0.0, 7
; expect: [zero_dividend] = 0.0

        two     no_coefficient, DIVU, X'0010 0000 0000 0000', 2.0
; expect: [no_coefficient] = X'000E 0000 0000 0000'

; divide fault
        two     by_zero, DIVU, 1.0, 0.0
; expect: [by_zero] = X'7000 0000 0000 0000'

        two     by_zero_coefficient, DIVU, 1.0, X'0010 0000 0000 0000'
; expect: [by_zero_coefficient] = X'7000 0000 0000 0000'

        two     zero_by_zero, DIVU, 0.0, 0.0
; expect: [zero_by_zero] = X'7000 0000 0000 0000'

        two     indefinite, DIVU, X'7000 0000 0000 0000', 1.0
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, DIVU, X'6FFF 7FFF FFFF FFFF', 0.125
; expect: [overflow] = X'7000 0000 0000 0000'

        two     underflow, DIVU, X'9000 4000 0000 0000', 4.0
; expect: [underflow] = 0.0

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        DIVU    r0, left, result
        keep    zero_first
; expect: [zero_first] = 0.0
        DIVU    left, r0, result
        keep    zero_second
; expect: [zero_second] = X'7000 0000 0000 0000'
        DIVU    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0072 0000'
