; MPYUH: T := upper(R x S)

        .include "half.inc"

        two     plain, MPYUH, 1.5, 2.25
; expect-halves: [plain] = X'EC36 0000'

        two     mixed, MPYUH, -0.5, 10.0
; expect-halves: [mixed] = -5.0

; unnormalised: integers
        two     integers, MPYUH, 6, 7
; expect-halves: [integers] = X'1700 0000'

        two     long, MPYUH, X'007F FFFF', X'007F FFFF'
; expect-halves: [long] = X'177F FFFE'

; the one product that does not fit 46 bits
        two     least, MPYUH, X'0080 0000', X'0080 0000'
; expect-halves: [least] = X'1840 0000'

; inexact: floor
        two     negative, MPYUH, 0.1, -0.3
; expect-halves: [negative] = X'E5C2 8F5C'

; as significant as the less significant operand
        two     less_significant, MPYUH, 5, 0.1
; expect-halves: [less_significant] = X'FD00 0003'

; -1 has no significant bit
        two     minus_one, MPYUH, -1, -1
; expect-halves: [minus_one] = X'1700 0000'

        two     zero_coefficient, MPYUH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = X'1100 0000'

        two     zero_left, MPYUH, 0.0, 7
; expect-halves: [zero_left] = 0.0

        two     zero_right, MPYUH, -1.5, 0.0
; expect-halves: [zero_right] = 0.0

        two     indefinite, MPYUH, X'7000 0000', 0.0
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, MPYUH, X'6F7F FFFF', 8.0
; expect-halves: [overflow] = X'7000 0000'

        two     underflow, MPYUH, X'9040 0000', 0.25
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        MPYUH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = 0.0
        MPYUH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = 0.0
        MPYUH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
; expect-warning: integer-operand
