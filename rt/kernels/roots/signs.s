; signs.s - computes all roots of polynomials by changes of sign alone.  These
; macros are a part of quartic_scalar.s and quartic_vector.s.
;
; A solid needs all its crossings with a ray, and they must come in pairs.  So
; only 0 counts as 0, and it is positive.  There is a root exactly where the
; signs of f differ at two successive points among
;
;   low, the knots, high
;
; The value at a knot is the same for the interval before it and the one after
; it, however inaccurate its last places are.  So the number of roots is even
; exactly if the signs at low and high agree.  A tangent has two roots or none.
; Two knots that are closer than their accuracy may be out of order, and so may
; the roots next to them; therefore a root is not allowed to be smaller than the
; previous one.
;
; Source: the project's notes on ray tracing, 0 and 3.1.

; Computes the root of f between knot and next, if there is one; knot := next.
        .macro  search_value_signs
        value_at q_next, q_next_f
        if_signs_differ q_knot_f, q_next_f, search_move\@
        refine_value
        append_root
search_move\@:
        move    q_next, q_knot
        move    q_next_f, q_knot_f
        .endm

; The root of f' between left and right, if there is one, is the next knot.
        .macro  search_slope_signs right
        slope_at \right, q_right_slope
        if_signs_differ q_left_slope, q_right_slope, search_none\@
        solver_copy q_knot, q_next              ; of a lane without a next knot
        refine_slope \right
        search_value_signs
search_none\@:
        move    q_right_slope, q_left_slope
        RTOR    \right, q_left
        .endm

        .macro  search_signs
        RTOR    q_low, q_left
        slope_at q_low, q_left_slope
        solver_copy q_low, q_knot
        value_at q_knot, q_knot_f
        search_slope_signs q_bend1
        search_slope_signs q_bend2
        search_slope_signs q_high
        solver_copy q_high, q_next
        search_value_signs
        .endm
