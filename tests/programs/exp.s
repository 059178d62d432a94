; EXP: T := exponent of R, as an integer

        .include "scalar.inc"

        one     plain, EXP, 1.0
; expect: [plain] = -46

        one     large, EXP, X'6FFF 7FFF FFFF FFFF'
; expect: [large] = 28671

        one     small, EXP, X'9000 4000 0000 0000'
; expect: [small] = -28672

        one     integer, EXP, 5
; expect: [integer] = 0

; specials: the field, sign extended
        one     zero, EXP, 0.0
; expect: [zero] = -32768

        one     indefinite, EXP, X'7000 0000 0000 0000'
; expect: [indefinite] = 28672

        EXIT
; expect-flags: X'0000 0000 0000 0000'
