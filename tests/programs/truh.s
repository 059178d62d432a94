; TRUH: T := R cut to an integer towards zero, exponent 0

        .include "half.inc"

        one     plain, TRUH, 2.75
; expect-halves: [plain] = 2

        one     negative, TRUH, -2.75
; expect-halves: [negative] = -2

        one     whole, TRUH, -3.0
; expect-halves: [whole] = -3

        one     small, TRUH, 0.5
; expect-halves: [small] = 0

        one     small_negative, TRUH, -0.5
; expect-halves: [small_negative] = 0

        one     tiny_negative, TRUH, X'9080 0000'
; expect-halves: [tiny_negative] = 0

; an exponent of 0 or more: unchanged
        one     integer, TRUH, -7
; expect-halves: [integer] = -7

        one     large, TRUH, X'0540 0000'
; expect-halves: [large] = X'0540 0000'

; 2.5
        one     unnormalised, TRUH, X'FF00 0005'
; expect-halves: [unnormalised] = 2

; specials stay
        one     zero, TRUH, 0.0
; expect-halves: [zero] = 0.0

        one     indefinite, TRUH, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; h0 is machine zero
        TRUH    h0, result
        keep    register_zero
; expect-halves: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
