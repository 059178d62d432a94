; ADDLH: T := lower(R + S)

        .include "half.inc"

        two     plain, ADDLH, 1.5, 2.25
; expect-halves: [plain] = X'D400 0000'

        two     mixed, ADDLH, 10.0, -0.5
; expect-halves: [mixed] = X'D600 0000'

        two     equal, ADDLH, 3.0, 3.0
; expect-halves: [equal] = X'D500 0000'

        two     opposite, ADDLH, 3.0, -3.0
; expect-halves: [opposite] = X'D400 0000'

; unnormalised: integers
        two     integers, ADDLH, 5, 3
; expect-halves: [integers] = X'E900 0000'

; coefficient overflow
        two     carry, ADDLH, X'007F FFFF', X'007F FFFF'
; expect-halves: [carry] = X'EA00 0000'

; a tiny negative operand counts: results are cut by floor
        two     under, ADDLH, 1.0, X'D280 0000'
; expect-halves: [under] = X'D340 0000'

; shifted out of the register altogether
        two     far, ADDLH, 1.0, X'9080 0000'
; expect-halves: [far] = X'D37F FFFF'

; inexact
        two     tenth, ADDLH, 0.1, 0.2
; expect-halves: [tenth] = X'D140 0000'

; its exponent counts in the alignment
        two     zero_coefficient, ADDLH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = X'F900 0080'

; machine zero leaves the other operand
        two     zero_left, ADDLH, 0.0, 7
; expect-halves: [zero_left] = X'E900 0000'

        two     zero_right, ADDLH, -1.5, 0.0
; expect-halves: [zero_right] = X'D300 0000'

        two     zero_both, ADDLH, 0.0, 0.0
; expect-halves: [zero_both] = 0.0

        two     indefinite, ADDLH, 1.0, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, ADDLH, X'6F7F FFFF', X'6F80 0000'
; expect-halves: [overflow] = X'5800 0000'

        two     huge, ADDLH, X'6F7F FFFF', X'6F7F FFFF'
; expect-halves: [huge] = X'5900 0000'

        two     underflow, ADDLH, X'9040 0001', X'9040 0000'
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        ADDLH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = X'D400 0000'
        ADDLH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = X'D400 0000'
        ADDLH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
