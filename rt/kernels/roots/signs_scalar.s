; signs_scalar.s - computes all roots of one polynomial by changes of sign
; alone.  These macros are a part of quartic_scalar.s.  The method is that of
; signs_vector.s.

        .share  local
        .reg    q_last, r78             ; previous root; replaces q_knot_touch
        .endshare

; Computes the root of f between knot and next, if there is one; knot := next.
        .macro  search_value_signs
        CFPEQ   q_next, q_knot, search_none\@
        quartic_value q_next, q_next_f
        same_sign q_knot_f, q_next_f, search_move\@
        refine_value
        CFPGE   q_answer, q_last, search_ascending\@
        RTOR    q_last, q_answer
search_ascending\@:
        RTOR    q_answer, q_last
        STO     [q_roots, q_count], q_answer
        IX      q_count, 1
search_move\@:
        RTOR    q_next, q_knot
        RTOR    q_next_f, q_knot_f
search_none\@:
        .endm

; The root of f' between left and right, if there is one, is the next knot.
        .macro  search_slope_signs right
        cubic_value \right, q_right_slope
        same_sign q_left_slope, q_right_slope, search_flat\@
        refine_slope \right
        search_value_signs
search_flat\@:
        RTOR    \right, q_left
        RTOR    q_right_slope, q_left_slope
        .endm

        .macro  search_signs
        SUBN    r0, q_none, q_last
        RTOR    q_low, q_left
        cubic_value q_low, q_left_slope
        RTOR    q_low, q_knot
        quartic_value q_low, q_knot_f
        search_slope_signs q_bend1
        search_slope_signs q_bend2
        search_slope_signs q_high
        RTOR    q_high, q_next
        search_value_signs
        .endm
