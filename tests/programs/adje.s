; ADJE: T := R with the exponent S, its coefficient shifted to suit;
; indefinite if it does not fit

        .include "scalar.inc"

        two     left_3, ADJE, 5, -3
; expect: [left_3] = X'FFFD 0000 0000 0028'

; to the right what leaves the coefficient is lost (floor)
        two     integer, ADJE, 1.0, 0
; expect: [integer] = 1

        two     fraction, ADJE, 2.75, 0
; expect: [fraction] = 2

        two     negative, ADJE, -2.75, 0
; expect: [negative] = -3

        two     all_lost, ADJE, -5, 100
; expect: [all_lost] = X'0064 FFFF FFFF FFFF'

        two     same, ADJE, 1.0, -46
; expect: [same] = 1.0

; what just fits, and what does not
        two     fits, ADJE, 1, -46
; expect: [fits] = 1.0

        two     minus_one, ADJE, -1, -47
; expect: [minus_one] = X'FFD1 8000 0000 0000'

        two     too_long, ADJE, 1, -47
; expect: [too_long] = X'7000 0000 0000 0000'

        two     far_too_long, ADJE, 1, -40000
; expect: [far_too_long] = X'7000 0000 0000 0000'

        two     zero_coefficient, ADJE, X'0010 0000 0000 0000', -100
; expect: [zero_coefficient] = X'FF9C 0000 0000 0000'

; only the low 48 bits of S count
        two     low_bits, ADJE, 5, X'1234 FFFF FFFF FFFD'
; expect: [low_bits] = X'FFFD 0000 0000 0028'

; the exponent leaves its range
        two     overflow, ADJE, 5, 28672
; expect: [overflow] = X'7000 0000 0000 0000'

        two     underflow, ADJE, X'9000 0000 0000 0001', -28673
; expect: [underflow] = 0.0

        two     zero_underflow, ADJE, X'0010 0000 0000 0000', -40000
; expect: [zero_underflow] = 0.0

; specials become the plain words
        two     zero, ADJE, X'8123 0000 0000 0005', 3
; expect: [zero] = 0.0

        two     indefinite, ADJE, X'7123 0000 0000 0005', -3
; expect: [indefinite] = X'7000 0000 0000 0000'

; register 0 is 0 for S
        fetch   left, 12.5
        ADJE    left, r0, result
        keep    register_zero
; expect: [register_zero] = 12

        EXIT
; expect-flags: X'0000 0000 0032 0000'
