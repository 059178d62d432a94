; MPYL: T := lower(R x S)

        .include "scalar.inc"

        two     plain, MPYL, 1.5, 2.25
; expect: [plain] = X'FFA5 0000 0000 0000'

        two     mixed, MPYL, -0.5, 10.0
; expect: [mixed] = X'FFA5 0000 0000 0000'

; unnormalised: integers
        two     integers, MPYL, 6, 7
; expect: [integers] = 42

        two     long, MPYL, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [long] = 1

; the one product that does not fit 94 bits
        two     least, MPYL, X'0000 8000 0000 0000', X'0000 8000 0000 0000'
; expect: [least] = 0

; inexact: floor
        two     negative, MPYL, 0.1, -0.3
; expect: [negative] = X'FF9E 51EB 851E B852'

; as significant as the less significant operand
        two     less_significant, MPYL, 5, 0.1
; expect: [less_significant] = X'FFCE 7FFF FFFF FFFE'

; -1 has no significant bit
        two     minus_one, MPYL, -1, -1
; expect: [minus_one] = 1

        two     zero_coefficient, MPYL, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = X'FFE2 0000 0000 0000'

        two     zero_left, MPYL, 0.0, 7
; expect: [zero_left] = 0.0

        two     zero_right, MPYL, -1.5, 0.0
; expect: [zero_right] = 0.0

        two     indefinite, MPYL, X'7000 0000 0000 0000', 0.0
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, MPYL, X'6FFF 7FFF FFFF FFFF', 8.0
; expect: [overflow] = X'6FD4 4000 0000 0000'

        two     underflow, MPYL, X'9000 4000 0000 0000', 0.25
; expect: [underflow] = 0.0

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        MPYL    r0, left, result
        keep    zero_first
; expect: [zero_first] = 0.0
        MPYL    left, r0, result
        keep    zero_second
; expect: [zero_second] = 0.0
        MPYL    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
