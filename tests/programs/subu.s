; SUBU: T := upper(R - S)

        .include "scalar.inc"

        two     plain, SUBU, 1.5, 2.25
; expect: [plain] = X'FFD3 E800 0000 0000'

        two     mixed, SUBU, 10.0, -0.5
; expect: [mixed] = 10.5

        two     equal, SUBU, 3.0, 3.0
; expect: [equal] = X'FFD3 0000 0000 0000'

        two     opposite, SUBU, 3.0, -3.0
; expect: [opposite] = 6.0

; unnormalised: integers
        two     integers, SUBU, 5, 3
; expect: [integers] = 2

; coefficient overflow
        two     carry, SUBU, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [carry] = 0

; a tiny negative operand counts: results are cut by floor
        two     under, SUBU, 1.0, X'FFA2 8000 0000 0000'
; expect: [under] = 1.0

; shifted out of the register altogether
        two     far, SUBU, 1.0, X'F000 8000 0000 0000'
; expect: [far] = 1.0

; inexact
        two     tenth, SUBU, 0.1, 0.2
; expect: [tenth] = X'FFCF CCCC CCCC CCCD'

; its exponent counts in the alignment
        two     zero_coefficient, SUBU, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = X'0010 0000 0000 0000'

; machine zero leaves the other operand
        two     zero_left, SUBU, 0.0, 7
; expect: [zero_left] = -7

        two     zero_right, SUBU, -1.5, 0.0
; expect: [zero_right] = -1.5

        two     zero_both, SUBU, 0.0, 0.0
; expect: [zero_both] = 0.0

        two     indefinite, SUBU, 1.0, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, SUBU, X'6FFF 7FFF FFFF FFFF', X'6FFF 8000 0000 0000'
; expect: [overflow] = X'7000 0000 0000 0000'

        two     huge, SUBU, X'6FFF 7FFF FFFF FFFF', X'6FFF 7FFF FFFF FFFF'
; expect: [huge] = X'6FFF 0000 0000 0000'

        two     underflow, SUBU, X'9000 4000 0000 0001', X'9000 4000 0000 0000'
; expect: [underflow] = X'9000 0000 0000 0001'

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        SUBU    r0, left, result
        keep    zero_first
; expect: [zero_first] = 2.5
        SUBU    left, r0, result
        keep    zero_second
; expect: [zero_second] = -2.5
        SUBU    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
