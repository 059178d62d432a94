; SUBL: T := lower(R - S)

        .include "scalar.inc"

        two     plain, SUBL, 1.5, 2.25
; expect: [plain] = X'FFA4 0000 0000 0000'

        two     mixed, SUBL, 10.0, -0.5
; expect: [mixed] = X'FFA6 0000 0000 0000'

        two     equal, SUBL, 3.0, 3.0
; expect: [equal] = X'FFA4 0000 0000 0000'

        two     opposite, SUBL, 3.0, -3.0
; expect: [opposite] = X'FFA5 0000 0000 0000'

; unnormalised: integers
        two     integers, SUBL, 5, 3
; expect: [integers] = X'FFD1 0000 0000 0000'

; coefficient overflow
        two     carry, SUBL, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [carry] = X'FFD1 0000 0000 0000'

; a tiny negative operand counts: results are cut by floor
        two     under, SUBL, 1.0, X'FFA2 8000 0000 0000'
; expect: [under] = X'FFA3 4000 0000 0000'

; shifted out of the register altogether
        two     far, SUBL, 1.0, X'F000 8000 0000 0000'
; expect: [far] = X'FFA3 0000 0000 0001'

; inexact
        two     tenth, SUBL, 0.1, 0.2
; expect: [tenth] = X'FFA0 0000 0000 0000'

; its exponent counts in the alignment
        two     zero_coefficient, SUBL, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = X'FFE1 0000 8000 0000'

; machine zero leaves the other operand
        two     zero_left, SUBL, 0.0, 7
; expect: [zero_left] = X'FFD1 0000 0000 0000'

        two     zero_right, SUBL, -1.5, 0.0
; expect: [zero_right] = X'FFA3 0000 0000 0000'

        two     zero_both, SUBL, 0.0, 0.0
; expect: [zero_both] = 0.0

        two     indefinite, SUBL, 1.0, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, SUBL, X'6FFF 7FFF FFFF FFFF', X'6FFF 8000 0000 0000'
; expect: [overflow] = X'6FD1 4000 0000 0000'

        two     huge, SUBL, X'6FFF 7FFF FFFF FFFF', X'6FFF 7FFF FFFF FFFF'
; expect: [huge] = X'6FD0 0000 0000 0000'

        two     underflow, SUBL, X'9000 4000 0000 0001', X'9000 4000 0000 0000'
; expect: [underflow] = 0.0

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        SUBL    r0, left, result
        keep    zero_first
; expect: [zero_first] = X'FFA4 0000 0000 0000'
        SUBL    left, r0, result
        keep    zero_second
; expect: [zero_second] = X'FFA4 0000 0000 0000'
        SUBL    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
