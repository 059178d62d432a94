; ADJEH: T := R with the exponent S, its coefficient shifted to suit;
; indefinite if it does not fit

        .include "half.inc"

        two     left_3, ADJEH, 5, -3
; expect-halves: [left_3] = X'FD00 0028'

; to the right what leaves the coefficient is lost (floor)
        two     integer, ADJEH, 1.0, 0
; expect-halves: [integer] = 1

        two     fraction, ADJEH, 2.75, 0
; expect-halves: [fraction] = 2

        two     negative, ADJEH, -2.75, 0
; expect-halves: [negative] = -3

        two     all_lost, ADJEH, -5, 100
; expect-halves: [all_lost] = X'64FF FFFF'

        two     same, ADJEH, 1.0, -22
; expect-halves: [same] = 1.0

; what just fits, and what does not
        two     fits, ADJEH, 1, -22
; expect-halves: [fits] = 1.0

        two     minus_one, ADJEH, -1, -23
; expect-halves: [minus_one] = X'E980 0000'

        two     too_long, ADJEH, 1, -23
; expect-halves: [too_long] = X'7000 0000'

        two     far_too_long, ADJEH, 1, -40000
; expect-halves: [far_too_long] = X'7000 0000'

        two     zero_coefficient, ADJEH, X'1000 0000', -100
; expect-halves: [zero_coefficient] = X'9C00 0000'

; only the low 24 bits of S count
        two     low_bits, ADJEH, 5, X'ECFF FFFD'
; expect-halves: [low_bits] = X'FD00 0028'

; the exponent leaves its range
        two     overflow, ADJEH, 5, 112
; expect-halves: [overflow] = X'7000 0000'

        two     underflow, ADJEH, X'9000 0001', -113
; expect-halves: [underflow] = 0.0

        two     zero_underflow, ADJEH, X'1000 0000', -40000
; expect-halves: [zero_underflow] = 0.0

; specials become the plain words
        two     zero, ADJEH, X'8000 0005', 3
; expect-halves: [zero] = 0.0

        two     indefinite, ADJEH, X'7000 0005', -3
; expect-halves: [indefinite] = X'7000 0000'

; register 0 is 0 for S
        fetch   left, 12.5
        ADJEH   left, h0, result
        keep    register_zero
; expect-halves: [register_zero] = 12

        EXIT
; expect-flags: X'0000 0000 0032 0000'
