; ADJS: T := R, its coefficient shifted left by S, no further than normalised,
; or right (negative)

        .include "scalar.inc"

        two     left_3, ADJS, 5, 3
; expect: [left_3] = X'FFFD 0000 0000 0028'

        two     normalised, ADJS, 5, 100
; expect: [normalised] = X'FFD4 5000 0000 0000'

        two     as_it_is, ADJS, 1.0, 5
; expect: [as_it_is] = 1.0

        two     minus_one, ADJS, -1, 47
; expect: [minus_one] = X'FFD1 8000 0000 0000'

; to the right what leaves the coefficient is lost (floor)
        two     right_2, ADJS, 13, -2
; expect: [right_2] = X'0002 0000 0000 0003'

        two     negative, ADJS, -13, -2
; expect: [negative] = X'0002 FFFF FFFF FFFC'

        two     all_lost, ADJS, 5, -50
; expect: [all_lost] = X'0032 0000 0000 0000'

        two     sign_left, ADJS, -5, -50
; expect: [sign_left] = X'0032 FFFF FFFF FFFF'

; a coefficient of 0 moves 47 places at the most
        two     zero_coefficient, ADJS, X'0010 0000 0000 0000', 60
; expect: [zero_coefficient] = X'FFE1 0000 0000 0000'

; only the low 48 bits of S count
        two     low_bits, ADJS, 5, X'1234 0000 0000 0003'
; expect: [low_bits] = X'FFFD 0000 0000 0028'

; the exponent leaves its range
        two     underflow, ADJS, X'9000 0000 0000 0005', 1
; expect: [underflow] = 0.0

        two     overflow, ADJS, X'6FFF 0000 0000 0005', -1
; expect: [overflow] = X'7000 0000 0000 0000'

        two     furthest, ADJS, 5, X'0000 8000 0000 0000'
; expect: [furthest] = X'7000 0000 0000 0000'

; specials become the plain words
        two     zero, ADJS, X'8123 0000 0000 0005', 3
; expect: [zero] = 0.0

        two     indefinite, ADJS, X'7123 0000 0000 0005', -3
; expect: [indefinite] = X'7000 0000 0000 0000'

; register 0 is machine zero for R, 0 for S
        ADJS    r0, right, result
        keep    of_register_zero
; expect: [of_register_zero] = 0.0
        fetch   left, 5
        ADJS    left, r0, result
        keep    by_register_zero
; expect: [by_register_zero] = 5

        EXIT
; expect-flags: X'0000 0000 0032 0000'
