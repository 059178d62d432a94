; series.s - polynomials of exp, log, sine and cosine: the words of their
; coefficients, and operations that evaluate them in both forms.
;
; All programs compute these functions with these polynomials: the routines of
; the library, which reduce any argument, and kernels whose arguments are in
; known ranges. A program loads the coefficients into the registers that the
; operations name. form is the prefix of the operations (forms.s), as in
; number_, or nothing.
;
; Each polynomial interpolates a function at Chebyshev points:
;
;   exp     (e^r - 1 - r) / r^2           |r| <= ln 2 / 2       9 points
;   log     (2 artanh s - 2 s) / s^3      of s^2, |s| <= 3 - 2 sqrt 2     6
;   sine    (sin r - r) / r^3             of r^2, |r| <= pi/2   7
;   cosine  (cos r - 1 + r^2 / 2) / r^4   of r^2, |r| <= pi/4   5

        .ifndef series.s
        .equ    series.s, 1

        .macro  exp_coefficients
        .word   5.0000000000000000000000e-01, 1.6666666666648302851375e-01
        .word   4.1666666666651367273706e-02, 8.3333333537171569677078e-03
        .word   1.3888888905871345596794e-03, 1.9841208756992321040719e-04
        .word   2.4801536409064086482771e-05, 2.7625102005388106898371e-06
        .word   2.7613795554519858706070e-07
        .endm

        .macro  log_coefficients
        .word   6.6666666666662083223228e-01, 4.0000000011206506321435e-01
        .word   2.8571424138324160584902e-01, 2.2222862280108715554131e-01
        .word   1.8140193802865991002223e-01, 1.6621817152858929503025e-01
        .endm

        .macro  sine_coefficients
        .word   -1.6666666666666648034995e-01, 8.3333333333259326764911e-03
        .word   -1.9841269836469024923539e-04, 2.7557318055685784254033e-06
        .word   -2.5051972921545551590685e-08, 1.6050972244135634775178e-10
        .word   -7.4080548895426098567927e-13
        .endm

        .macro  cosine_coefficients
        .word   4.1666666666664678603829e-02, -1.3888888887277342898921e-03
        .word   2.4801585210990515948197e-05, -2.7556369695573006222767e-07
        .word   2.0700600483433117897579e-09
        .endm

; result = 2^k e^r, for an integer k. sum and work are changed.
        .macro  exp_of_rest form=, r, k, sum, work, result
        \form\()line  \r, exp_8, exp_7, \sum
        \form\()step  \r, exp_6, \sum
        \form\()step  \r, exp_5, \sum
        \form\()step  \r, exp_4, \sum
        \form\()step  \r, exp_3, \sum
        \form\()step  \r, exp_2, \sum
        \form\()step  \r, exp_1, \sum
        \form\()step  \r, exp_0, \sum
        \form\()times \sum, \r, \sum
        \form\()times \sum, \r, \sum
        \form\()plus  \sum, \r, \sum
        \form\()raise \sum, exp_one, \sum            ; e^r
        \form\()exponent \sum, \work
        \form\()plus_index \work, \k, \work
        \form\()pack_each \work, \sum, \work
        \form\()normal \work, \result
        .endm

        .macro  log_polynomial form=, square, sum
        \form\()line  \square, log_5, log_4, \sum
        \form\()step  \square, log_3, \sum
        \form\()step  \square, log_2, \sum
        \form\()step  \square, log_1, \sum
        \form\()step  \square, log_0, \sum
        .endm

        .macro  sine_polynomial form=, square, sum
        \form\()line  \square, sine_6, sine_5, \sum
        \form\()step  \square, sine_4, \sum
        \form\()step  \square, sine_3, \sum
        \form\()step  \square, sine_2, \sum
        \form\()step  \square, sine_1, \sum
        \form\()step  \square, sine_0, \sum
        .endm

; The same of two squares. Even and odd powers have sums of their own, which the
; scalar form interleaves. fourth, odd and the last two are scratch.
        .macro  sine_polynomials form=, square, sum, fourth, odd, other, other_sum, other_fourth, other_odd
        \form\()times \square, \square, \fourth
        \form\()times \other, \other, \other_fourth
        \form\()line_four \fourth, \other_fourth, sine_6, sine_4, sine_5, sine_3, \sum, \odd, \other_sum, \other_odd
        \form\()step_four \fourth, \other_fourth, sine_2, sine_1, \sum, \odd, \other_sum, \other_odd
        \form\()step_two \fourth, sine_0, \sum, \other_fourth, sine_0, \other_sum
        \form\()times \odd, \square, \odd
        \form\()times \other_odd, \other, \other_odd
        \form\()plus  \sum, \odd, \sum
        \form\()plus  \other_sum, \other_odd, \other_sum
        .endm

; sum = cos r.
        .macro  cosine_of_rest form=, square, sum
        \form\()line  \square, cosine_4, cosine_3, \sum
        \form\()step  \square, cosine_2, \sum
        \form\()step  \square, cosine_1, \sum
        \form\()step  \square, cosine_0, \sum
        \form\()step  \square, sin_minus_half, \sum
        \form\()step  \square, sin_one, \sum
        .endm

        .endif
