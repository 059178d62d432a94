; signs_vector.s - computes all roots of many polynomials by changes of sign
; alone.  These macros are a part of quartic_vector.s.
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

; Computes the roots of f between knot and next.
        .macro  search_value_signs
        quartic_polynomial q_next, q_next_f, q_c4, q_c3, q_c2, q_c1, q_c0
        signs_differ q_knot_f, q_next_f, q_need
        ANDB    [q_need], [q_alive], [q_need]
        count_lanes q_need, search_move\@
        refine_value
        CNTOB   [q_need], q_u
        CPSV    [q_root], [q_t] ? [q_need]
        give_place
search_move\@:
        exchange q_next, q_knot
        exchange q_next_f, q_knot_f
        .endm

; The roots of f' between left and right are the next knots.
        .macro  search_slope_signs right
        cubic_polynomial \right, q_right_slope, q_s3, q_s2, q_s1, q_c1
        signs_differ q_left_slope, q_right_slope, q_need
        ANDB    [q_need], [q_alive], [q_need]
        count_lanes q_need, search_none\@
        VTOV    [q_knot], [q_next]
        refine_slope \right
        search_value_signs
search_none\@:
        exchange q_left_slope, q_right_slope
        RTOR    \right, q_left
        .endm

        .macro  no_less before, root
        CMPLTV  [\root], [\before], [q_sign]
        VTOV    [\before], [\root] ? [q_sign]
        .endm

        .macro  search_signs
        RTOR    q_low, q_left
        cubic_polynomial q_low, q_left_slope, q_s3, q_s2, q_s1, q_c1
        VTOV    [q_low], [q_knot]
        quartic_polynomial q_knot, q_knot_f, q_c4, q_c3, q_c2, q_c1, q_c0
        search_slope_signs q_bend1
        search_slope_signs q_bend2
        search_slope_signs q_high
        VTOV    [q_high], [q_next]
        search_value_signs
        VTOVX   [q_lane], [q_count], [root_count]
        LTOR    root0, q_u
        lengthen q_u, q_sign
        no_less root0, root1
        no_less root1, root2
        no_less root2, root3
        .endm
