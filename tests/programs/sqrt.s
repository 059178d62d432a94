; SQRT: T := square root of R

        .include "scalar.inc"

        one     four, SQRT, 4.0
; expect: [four] = 2.0

; floor
        one     inexact, SQRT, 2.0
; expect: [inexact] = X'FFD2 5A82 7999 FCEF'

        one     quarter, SQRT, 0.0625
; expect: [quarter] = 0.25

; as many significant bits as the operand: 16 has 5
        one     integer, SQRT, 16
; expect: [integer] = X'FFFE 0000 0000 0010'

; 18, of 4 bits
        one     unnormalised, SQRT, X'0001 0000 0000 0009'
; expect: [unnormalised] = X'FFFF 0000 0000 0008'

        one     large, SQRT, X'6FFF 7FFF FFFF FFFF'
; expect: [large] = X'37E8 7FFF FFFF FFFF'

        one     small, SQRT, X'9000 4000 0000 0000'
; expect: [small] = X'C7E9 4000 0000 0000'

        one     zero, SQRT, 0.0
; expect: [zero] = 0.0

        one     zero_coefficient, SQRT, X'0010 0000 0000 0000'
; expect: [zero_coefficient] = 0.0

; imaginary root
        one     imaginary, SQRT, -1.0
; expect: [imaginary] = X'7000 0000 0000 0000'

        one     indefinite, SQRT, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; r0 is machine zero
        SQRT    r0, result
        keep    register_zero
; expect: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0016 0000'
