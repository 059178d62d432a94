; CLGH: T := least integer not below R, exponent 0

        .include "half.inc"

        one     plain, CLGH, 2.75
; expect-halves: [plain] = 3

        one     negative, CLGH, -2.75
; expect-halves: [negative] = -2

        one     whole, CLGH, -3.0
; expect-halves: [whole] = -3

        one     small, CLGH, 0.5
; expect-halves: [small] = 1

        one     small_negative, CLGH, -0.5
; expect-halves: [small_negative] = 0

        one     tiny, CLGH, X'9040 0000'
; expect-halves: [tiny] = 1

        one     least, CLGH, X'FF80 0000'
; expect-halves: [least] = X'00C0 0000'

; an exponent of 0 or more: unchanged
        one     integer, CLGH, -7
; expect-halves: [integer] = -7

        one     large, CLGH, X'0540 0000'
; expect-halves: [large] = X'0540 0000'

; 2.5
        one     unnormalised, CLGH, X'FF00 0005'
; expect-halves: [unnormalised] = 3

; specials stay
        one     zero, CLGH, X'8000 0005'
; expect-halves: [zero] = X'8000 0005'

        one     indefinite, CLGH, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; h0 is machine zero
        CLGH    h0, result
        keep    register_zero
; expect-halves: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
