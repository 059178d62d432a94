; ADDU: T := upper(R + S)

        .include "scalar.inc"

        two     plain, ADDU, 1.5, 2.25
; expect: [plain] = 3.75

        two     mixed, ADDU, 10.0, -0.5
; expect: [mixed] = 9.5

        two     equal, ADDU, 3.0, 3.0
; expect: [equal] = 6.0

        two     opposite, ADDU, 3.0, -3.0
; expect: [opposite] = X'FFD3 0000 0000 0000'

; unnormalised: integers
        two     integers, ADDU, 5, 3
; expect: [integers] = 8

; coefficient overflow
        two     carry, ADDU, X'0000 7FFF FFFF FFFF', X'0000 7FFF FFFF FFFF'
; expect: [carry] = X'0001 7FFF FFFF FFFF'

; a tiny negative operand counts: results are cut by floor
        two     under, ADDU, 1.0, X'FFA2 8000 0000 0000'
; expect: [under] = X'FFD2 3FFF FFFF FFFF'

; shifted out of the register altogether
        two     far, ADDU, 1.0, X'F000 8000 0000 0000'
; expect: [far] = X'FFD2 3FFF FFFF FFFF'

; inexact
        two     tenth, ADDU, 0.1, 0.2
; expect: [tenth] = X'FFD0 4CCC CCCC CCCC'

; its exponent counts in the alignment
        two     zero_coefficient, ADDU, 1.0, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = X'0010 0000 0000 0000'

; machine zero leaves the other operand
        two     zero_left, ADDU, 0.0, 7
; expect: [zero_left] = 7

        two     zero_right, ADDU, -1.5, 0.0
; expect: [zero_right] = -1.5

        two     zero_both, ADDU, 0.0, 0.0
; expect: [zero_both] = 0.0

        two     indefinite, ADDU, 1.0, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; at the ends of the exponent range
        two     overflow, ADDU, X'6FFF 7FFF FFFF FFFF', X'6FFF 8000 0000 0000'
; expect: [overflow] = X'6FFF FFFF FFFF FFFF'

        two     huge, ADDU, X'6FFF 7FFF FFFF FFFF', X'6FFF 7FFF FFFF FFFF'
; expect: [huge] = X'7000 0000 0000 0000'

        two     underflow, ADDU, X'9000 4000 0000 0001', X'9000 4000 0000 0000'
; expect: [underflow] = X'9001 4000 0000 0000'

; r0 is machine zero as an operand, and takes no result
        fetch   left, -2.5
        ADDU    r0, left, result
        keep    zero_first
; expect: [zero_first] = -2.5
        ADDU    left, r0, result
        keep    zero_second
; expect: [zero_second] = -2.5
        ADDU    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
