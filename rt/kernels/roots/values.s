; values.s - computes values of polynomials by Horner's rule.  These macros are
; a part of quartic_scalar.s and quartic_vector.s.

        .macro  horner_step x, fx, c
        solver_times \fx, \x, \fx
        solver_plus \fx, \c, \fx
        .endm

        .macro  cubic_polynomial x, fx, c3, c2, c1, c0
        solver_times \c3, \x, \fx
        solver_plus \fx, \c2, \fx
        horner_step \x, \fx, \c1
        horner_step \x, \fx, \c0
        .endm

        .macro  quartic_polynomial x, fx, c4, c3, c2, c1, c0
        cubic_polynomial \x, \fx, \c4, \c3, \c2, \c1
        horner_step \x, \fx, \c0
        .endm

; fx = the value of f at x.
        .macro  value_at x, fx
        quartic_polynomial \x, \fx, q_c4, q_c3, q_c2, q_c1, q_c0
        .endm

; fx = the value of f' at x.
        .macro  slope_at x, fx
        cubic_polynomial \x, \fx, q_s3, q_s2, q_s1, q_c1
        .endm

; Computes the coefficients of f'.
        .macro  derive
        solver_scale q_c4, q_four, q_s3
        solver_scale q_c3, q_three, q_s2
        solver_plus q_c2, q_c2, q_s1
        .endm

; q_w = f' / f'' at q_next, Newton's step on f'.
        .macro  newton_on_slope
        slope_at q_next, q_w
        solver_scale q_s3, q_three, q_s
        solver_plus q_s2, q_s2, q_d
        horner_step q_next, q_s, q_d
        horner_step q_next, q_s, q_s1
        solver_quotient q_w, q_s, q_w
        .endm
