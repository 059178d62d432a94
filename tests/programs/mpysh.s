; MPYSH: T := significant(R x S)

        .include "half.inc"

        two     plain, MPYSH, 1.5, 2.25
; expect-halves: [plain] = 3.375

        two     mixed, MPYSH, -0.5, 10.0
; expect-halves: [mixed] = -5.0

; unnormalised: integers
        two     integers, MPYSH, 6, 7
; expect-halves: [integers] = X'0300 0005'

        two     long, MPYSH, X'007F FFFF', X'007F FFFF'
; expect-halves: [long] = X'177F FFFE'

; the one product that does not fit 46 bits
        two     least, MPYSH, X'0080 0000', X'0080 0000'
; expect-halves: [least] = X'1840 0000'

; inexact: floor
        two     negative, MPYSH, 0.1, -0.3
; expect-halves: [negative] = X'E485 1EB8'

; as significant as the less significant operand
        two     less_significant, MPYSH, 5, 0.1
; expect-halves: [less_significant] = X'FC00 0007'

; -1 has no significant bit
        two     minus_one, MPYSH, -1, -1
; expect-halves: [minus_one] = 1

        two     zero_coefficient, MPYSH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = 0.0

        two     zero_left, MPYSH, 0.0, 7
; expect-halves: [zero_left] = 0.0

        two     zero_right, MPYSH, -1.5, 0.0
; expect-halves: [zero_right] = 0.0

        two     indefinite, MPYSH, X'7000 0000', 0.0
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, MPYSH, X'6F7F FFFF', 8.0
; expect-halves: [overflow] = X'7000 0000'

        two     underflow, MPYSH, X'9040 0000', 0.25
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        MPYSH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = 0.0
        MPYSH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = 0.0
        MPYSH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
; expect-warning: integer-operand
