; FLR: T := greatest integer not above R, exponent 0

        .include "scalar.inc"

        one     plain, FLR, 2.75
; expect: [plain] = 2

        one     negative, FLR, -2.75
; expect: [negative] = -3

        one     whole, FLR, -3.0
; expect: [whole] = -3

        one     small, FLR, 0.5
; expect: [small] = 0

        one     small_negative, FLR, -0.5
; expect: [small_negative] = -1

        one     tiny_negative, FLR, X'F000 8000 0000 0000'
; expect: [tiny_negative] = -1

; an exponent of 0 or more: unchanged
        one     integer, FLR, -7
; expect: [integer] = -7

        one     large, FLR, X'0005 4000 0000 0000'
; expect: [large] = X'0005 4000 0000 0000'

; 2.5
        one     unnormalised, FLR, X'FFFF 0000 0000 0005'
; expect: [unnormalised] = 2

; specials stay
        one     zero, FLR, 0.0
; expect: [zero] = 0.0

        one     indefinite, FLR, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; r0 is machine zero
        FLR     r0, result
        keep    register_zero
; expect: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
