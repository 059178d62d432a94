; MPYS: T := significant(R x S)

        .include "scalar.inc"

        two     plain, MPYS, 1.5, 2.25
; expect: [plain] = 3.375

        two     mixed, MPYS, -0.5, 10.0
; expect: [mixed] = -5.0

; unnormalised: integers
        two     integers, MPYS, 6, 7
; expect: [integers] = X'0003 0000 0000 0005'

        two     long, MPYS, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [long] = X'002F 7FFF FFFF FFFE'

; the one product that does not fit 94 bits
        two     least, MPYS, X'0000 8000 0000 0000', X'0000 8000 0000 0000'
; expect: [least] = X'0030 4000 0000 0000'

; inexact: floor
        two     negative, MPYS, 0.1, -0.3
; expect: [negative] = X'FFCC 851E B851 EB85'

; as significant as the less significant operand
        two     less_significant, MPYS, 5, 0.1
; expect: [less_significant] = X'FFFC 0000 0000 0007'

; -1 has no significant bit
        two     minus_one, MPYS, -1, -1
; expect: [minus_one] = 1

        two     zero_coefficient, MPYS, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = 0.0

        two     zero_left, MPYS, 0.0, 7
; expect: [zero_left] = 0.0

        two     zero_right, MPYS, -1.5, 0.0
; expect: [zero_right] = 0.0

        two     indefinite, MPYS, X'7000 0000 0000 0000', 0.0
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, MPYS, X'6FFF 7FFF FFFF FFFF', 8.0
; expect: [overflow] = X'7000 0000 0000 0000'

        two     underflow, MPYS, X'9000 4000 0000 0000', 0.25
; expect: [underflow] = 0.0

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        MPYS    r0, left, result
        keep    zero_first
; expect: [zero_first] = 0.0
        MPYS    left, r0, result
        keep    zero_second
; expect: [zero_second] = 0.0
        MPYS    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
; expect-warning: integer-operand
