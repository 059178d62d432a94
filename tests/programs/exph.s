; EXPH: T := exponent of R, as an integer

        .include "half.inc"

        one     plain, EXPH, 1.0
; expect-halves: [plain] = -22

        one     large, EXPH, X'6F7F FFFF'
; expect-halves: [large] = 111

        one     small, EXPH, X'9040 0000'
; expect-halves: [small] = -112

        one     integer, EXPH, 5
; expect-halves: [integer] = 0

; specials: the field, sign extended
        one     zero, EXPH, 0.0
; expect-halves: [zero] = -128

        one     indefinite, EXPH, X'7000 0000'
; expect-halves: [indefinite] = 112

        EXIT
; expect-flags: X'0000 0000 0000 0000'
