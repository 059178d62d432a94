; SUBLH: T := lower(R - S)

        .include "half.inc"

        two     plain, SUBLH, 1.5, 2.25
; expect-halves: [plain] = X'D400 0000'

        two     mixed, SUBLH, 10.0, -0.5
; expect-halves: [mixed] = X'D600 0000'

        two     equal, SUBLH, 3.0, 3.0
; expect-halves: [equal] = X'D400 0000'

        two     opposite, SUBLH, 3.0, -3.0
; expect-halves: [opposite] = X'D500 0000'

; unnormalised: integers
        two     integers, SUBLH, 5, 3
; expect-halves: [integers] = X'E900 0000'

; coefficient overflow
        two     carry, SUBLH, X'007F FFFF', X'007F FFFF'
; expect-halves: [carry] = X'E900 0000'

; a tiny negative operand counts: results are cut by floor
        two     under, SUBLH, 1.0, X'D280 0000'
; expect-halves: [under] = X'D340 0000'

; shifted out of the register altogether
        two     far, SUBLH, 1.0, X'9080 0000'
; expect-halves: [far] = X'D300 0001'

; inexact
        two     tenth, SUBLH, 0.1, 0.2
; expect-halves: [tenth] = X'D000 0000'

; its exponent counts in the alignment
        two     zero_coefficient, SUBLH, 1.0, X'1000 0000'
; expect-halves: [zero_coefficient] = X'F900 0080'

; machine zero leaves the other operand
        two     zero_left, SUBLH, 0.0, 7
; expect-halves: [zero_left] = X'E900 0000'

        two     zero_right, SUBLH, -1.5, 0.0
; expect-halves: [zero_right] = X'D300 0000'

        two     zero_both, SUBLH, 0.0, 0.0
; expect-halves: [zero_both] = 0.0

        two     indefinite, SUBLH, 1.0, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; at the ends of the exponent range
        two     overflow, SUBLH, X'6F7F FFFF', X'6F80 0000'
; expect-halves: [overflow] = X'5940 0000'

        two     huge, SUBLH, X'6F7F FFFF', X'6F7F FFFF'
; expect-halves: [huge] = X'5800 0000'

        two     underflow, SUBLH, X'9040 0001', X'9040 0000'
; expect-halves: [underflow] = 0.0

; h0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        SUBLH   h0, left, result
        keep    zero_first
; expect-halves: [zero_first] = X'D400 0000'
        SUBLH   left, h0, result
        keep    zero_second
; expect-halves: [zero_second] = X'D400 0000'
        SUBLH   left, left, h0
; expect: h0 = 0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
