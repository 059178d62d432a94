; SQRTH: T := square root of R

        .include "half.inc"

        one     four, SQRTH, 4.0
; expect-halves: [four] = 2.0

; floor
        one     inexact, SQRTH, 2.0
; expect-halves: [inexact] = X'EA5A 8279'

        one     quarter, SQRTH, 0.0625
; expect-halves: [quarter] = 0.25

; as many significant bits as the operand: 16 has 5
        one     integer, SQRTH, 16
; expect-halves: [integer] = X'FE00 0010'

; 18, of 4 bits
        one     unnormalised, SQRTH, X'0100 0009'
; expect-halves: [unnormalised] = X'FF00 0008'

        one     large, SQRTH, X'6F7F FFFF'
; expect-halves: [large] = X'2C7F FFFF'

        one     small, SQRTH, X'9040 0000'
; expect-halves: [small] = X'BD40 0000'

        one     zero, SQRTH, 0.0
; expect-halves: [zero] = 0.0

        one     zero_coefficient, SQRTH, X'1000 0000'
; expect-halves: [zero_coefficient] = 0.0

; imaginary root
        one     imaginary, SQRTH, -1.0
; expect-halves: [imaginary] = X'7000 0000'

        one     indefinite, SQRTH, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; h0 is machine zero
        SQRTH   h0, result
        keep    register_zero
; expect-halves: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0016 0000'
