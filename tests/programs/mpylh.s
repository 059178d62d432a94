; MPYLH: T := lower(R x S)

        .include "half.inc"

        two     plain, MPYLH, 1.5, 2.25
; expect-halves: [plain] = X'D500 0000'

        two     mixed, MPYLH, -0.5, 10.0
; expect-halves: [mixed] = X'D500 0000'

; unnormalised: integers
        two     integers, MPYLH, 6, 7
; expect-halves: [integers] = 42

        two     long, MPYLH, X'007F FFFF', X'007F FFFF'
; expect-halves: [long] = 1

; the one product that does not fit 46 bits
        two     least, MPYLH, X'0080 0000', X'0080 0000'
; expect-halves: [least] = 0

; inexact: floor
        two     negative, MPYLH, 0.1, -0.3
; expect-halves: [negative] = X'CE1E B852'

; as significant as the less significant operand
        two     less_significant, MPYLH, 5, 0.1
; expect-halves: [less_significant] = X'E67F FFFE'

; -1 has no significant bit
        two     minus_one, MPYLH, -1, -1
; expect-halves: [minus_one] = 1

        two     zero_coefficient, MPYLH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = X'FA00 0000'

        two     zero_left, MPYLH, 0.0, 7
; expect-halves: [zero_left] = 0.0

        two     zero_right, MPYLH, -1.5, 0.0
; expect-halves: [zero_right] = 0.0

        two     indefinite, MPYLH, X'7000 0000', 0.0
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, MPYLH, X'6F7F FFFF', 8.0
; expect-halves: [overflow] = X'5C40 0000'

        two     underflow, MPYLH, X'9040 0000', 0.25
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        MPYLH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = 0.0
        MPYLH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = 0.0
        MPYLH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
