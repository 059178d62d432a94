; TRU: T := R cut to an integer towards zero, exponent 0

        .include "scalar.inc"

        one     plain, TRU, 2.75
; expect: [plain] = 2

        one     negative, TRU, -2.75
; expect: [negative] = -2

        one     whole, TRU, -3.0
; expect: [whole] = -3

        one     small, TRU, 0.5
; expect: [small] = 0

        one     small_negative, TRU, -0.5
; expect: [small_negative] = 0

        one     tiny_negative, TRU, X'F000 8000 0000 0000'
; expect: [tiny_negative] = 0

; an exponent of 0 or more: unchanged
        one     integer, TRU, -7
; expect: [integer] = -7

        one     large, TRU, X'0005 4000 0000 0000'
; expect: [large] = X'0005 4000 0000 0000'

; 2.5
        one     unnormalised, TRU, X'FFFF 0000 0000 0005'
; expect: [unnormalised] = 2

; specials stay
        one     zero, TRU, 0.0
; expect: [zero] = 0.0

        one     indefinite, TRU, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; r0 is machine zero
        TRU     r0, result
        keep    register_zero
; expect: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
