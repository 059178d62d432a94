; MPYU: T := upper(R x S)

        .include "scalar.inc"

        two     plain, MPYU, 1.5, 2.25
; expect: [plain] = X'FFD4 3600 0000 0000'

        two     mixed, MPYU, -0.5, 10.0
; expect: [mixed] = -5.0

; unnormalised: integers
        two     integers, MPYU, 6, 7
; expect: [integers] = X'002F 0000 0000 0000'

        two     long, MPYU, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [long] = X'002F 7FFF FFFF FFFE'

; the one product that does not fit 94 bits
        two     least, MPYU, X'0000 8000 0000 0000', X'0000 8000 0000 0000'
; expect: [least] = X'0030 4000 0000 0000'

; inexact: floor
        two     negative, MPYU, 0.1, -0.3
; expect: [negative] = X'FFCD C28F 5C28 F5C2'

; as significant as the less significant operand
        two     less_significant, MPYU, 5, 0.1
; expect: [less_significant] = X'FFFD 0000 0000 0003'

; -1 has no significant bit
        two     minus_one, MPYU, -1, -1
; expect: [minus_one] = X'002F 0000 0000 0000'

        two     zero_coefficient, MPYU, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = X'0011 0000 0000 0000'

        two     zero_left, MPYU, 0.0, 7
; expect: [zero_left] = 0.0

        two     zero_right, MPYU, -1.5, 0.0
; expect: [zero_right] = 0.0

        two     indefinite, MPYU, X'7000 0000 0000 0000', 0.0
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, MPYU, X'6FFF 7FFF FFFF FFFF', 8.0
; expect: [overflow] = X'7000 0000 0000 0000'

        two     underflow, MPYU, X'9000 4000 0000 0000', 0.25
; expect: [underflow] = 0.0

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        MPYU    r0, left, result
        keep    zero_first
; expect: [zero_first] = 0.0
        MPYU    left, r0, result
        keep    zero_second
; expect: [zero_second] = 0.0
        MPYU    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
; expect-warning: integer-operand
