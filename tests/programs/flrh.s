; FLRH: T := greatest integer not above R, exponent 0

        .include "half.inc"

        one     plain, FLRH, 2.75
; expect-halves: [plain] = 2

        one     negative, FLRH, -2.75
; expect-halves: [negative] = -3

        one     whole, FLRH, -3.0
; expect-halves: [whole] = -3

        one     small, FLRH, 0.5
; expect-halves: [small] = 0

        one     small_negative, FLRH, -0.5
; expect-halves: [small_negative] = -1

        one     tiny_negative, FLRH, X'9080 0000'
; expect-halves: [tiny_negative] = -1

; an exponent of 0 or more: unchanged
        one     integer, FLRH, -7
; expect-halves: [integer] = -7

        one     large, FLRH, X'0540 0000'
; expect-halves: [large] = X'0540 0000'

; 2.5
        one     unnormalised, FLRH, X'FF00 0005'
; expect-halves: [unnormalised] = 2

; specials stay
        one     zero, FLRH, 0.0
; expect-halves: [zero] = 0.0

        one     indefinite, FLRH, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; h0 is machine zero
        FLRH    h0, result
        keep    register_zero
; expect-halves: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
