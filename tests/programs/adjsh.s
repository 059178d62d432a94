; ADJSH: T := R, its coefficient shifted left by S, no further than
; normalised, or right (negative)

        .include "half.inc"

        two     left_3, ADJSH, 5, 3
; expect-halves: [left_3] = X'FD00 0028'

        two     normalised, ADJSH, 5, 100
; expect-halves: [normalised] = X'EC50 0000'

        two     as_it_is, ADJSH, 1.0, 5
; expect-halves: [as_it_is] = 1.0

        two     minus_one, ADJSH, -1, 47
; expect-halves: [minus_one] = X'E980 0000'

; to the right what leaves the coefficient is lost (floor)
        two     right_2, ADJSH, 13, -2
; expect-halves: [right_2] = X'0200 0003'

        two     negative, ADJSH, -13, -2
; expect-halves: [negative] = X'02FF FFFC'

        two     all_lost, ADJSH, 5, -50
; expect-halves: [all_lost] = X'3200 0000'

        two     sign_left, ADJSH, -5, -50
; expect-halves: [sign_left] = X'32FF FFFF'

; a coefficient of 0 moves 23 places at the most
        two     zero_coefficient, ADJSH, X'1000 0000', 60
; expect-halves: [zero_coefficient] = X'F900 0000'

; only the low 24 bits of S count
        two     low_bits, ADJSH, 5, X'EC00 0003'
; expect-halves: [low_bits] = X'FD00 0028'

; the exponent leaves its range
        two     underflow, ADJSH, X'9000 0005', 1
; expect-halves: [underflow] = 0.0

        two     overflow, ADJSH, X'6F00 0005', -1
; expect-halves: [overflow] = X'7000 0000'

        two     furthest, ADJSH, 5, X'0080 0000'
; expect-halves: [furthest] = X'7000 0000'

; specials become the plain words
        two     zero, ADJSH, X'8000 0005', 3
; expect-halves: [zero] = 0.0

        two     indefinite, ADJSH, X'7000 0005', -3
; expect-halves: [indefinite] = X'7000 0000'

; register 0 is machine zero for R, 0 for S
        ADJSH   h0, right, result
        keep    of_register_zero
; expect-halves: [of_register_zero] = 0.0
        fetch   left, 5
        ADJSH   left, h0, result
        keep    by_register_zero
; expect-halves: [by_register_zero] = 5

        EXIT
; expect-flags: X'0000 0000 0032 0000'
