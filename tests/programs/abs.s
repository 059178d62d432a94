; ABS: T := |R|

        .include "scalar.inc"

        one     positive, ABS, 2.5
; expect: [positive] = 2.5

        one     negative, ABS, -2.5
; expect: [negative] = 2.5

        one     integer, ABS, -7
; expect: [integer] = 7

; 2^47 does not fit: exponent one more
        one     least, ABS, X'0000 8000 0000 0000'
; expect: [least] = X'0001 4000 0000 0000'

; specials stay
        one     zero, ABS, 0.0
; expect: [zero] = 0.0

        one     indefinite, ABS, X'7000 0000 0000 0000'
; expect: [indefinite] = X'7000 0000 0000 0000'

; exponent overflow
        one     overflow, ABS, X'6FFF 8000 0000 0000'
; expect: [overflow] = X'7000 0000 0000 0000'

; r0 is machine zero
        ABS     r0, result
        keep    register_zero
; expect: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
