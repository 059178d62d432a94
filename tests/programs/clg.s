; CLG: T := least integer not below R, exponent 0

        .include "scalar.inc"

        one     plain, CLG, 2.75
; expect: [plain] = 3

        one     negative, CLG, -2.75
; expect: [negative] = -2

        one     whole, CLG, -3.0
; expect: [whole] = -3

        one     small, CLG, 0.5
; expect: [small] = 1

        one     small_negative, CLG, -0.5
; expect: [small_negative] = 0

        one     tiny, CLG, X'F000 4000 0000 0000'
; expect: [tiny] = 1

        one     least, CLG, X'FFFF 8000 0000 0000'
; expect: [least] = X'0000 C000 0000 0000'

; an exponent of 0 or more: unchanged
        one     integer, CLG, -7
; expect: [integer] = -7

        one     large, CLG, X'0005 4000 0000 0000'
; expect: [large] = X'0005 4000 0000 0000'

; 2.5
        one     unnormalised, CLG, X'FFFF 0000 0000 0005'
; expect: [unnormalised] = 3

; specials stay
        one     zero, CLG, X'8123 0000 0000 0005'
; expect: [zero] = X'8123 0000 0000 0005'

        one     indefinite, CLG, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; r0 is machine zero
        CLG     r0, result
        keep    register_zero
; expect: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
