; ABSH: T := |R|

        .include "half.inc"

        one     positive, ABSH, 2.5
; expect-halves: [positive] = 2.5

        one     negative, ABSH, -2.5
; expect-halves: [negative] = 2.5

        one     integer, ABSH, -7
; expect-halves: [integer] = 7

; 2^23 does not fit: exponent one more
        one     least, ABSH, X'0080 0000'
; expect-halves: [least] = X'0140 0000'

; specials stay
        one     zero, ABSH, 0.0
; expect-halves: [zero] = 0.0

        one     indefinite, ABSH, X'7000 0000'
; expect-halves: [indefinite] = X'7000 0000'

; exponent overflow
        one     overflow, ABSH, X'6F80 0000'
; expect-halves: [overflow] = X'7000 0000'

; h0 is machine zero
        ABSH    h0, result
        keep    register_zero
; expect-halves: [register_zero] = 0.0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
