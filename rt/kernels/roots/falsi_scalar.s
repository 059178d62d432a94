; falsi_scalar.s - refines a root of one polynomial between two ends with
; different signs.  The method is that of falsi_vector.s.  The macro
;
;       refine  NAME, value, close
;
; makes the routine NAME for one degree, called by BSAVE q_link.  The macro
; value x, fx evaluates the polynomial; close is the closeness.
;
; In:  q_a, q_fa and q_b, q_fb, the ends and the values there; q_resolution.
; Out: q_answer.  Changes q_x, q_fx, q_w, q_s, q_d, q_t, q_u, q_steps.

; Reduces f(A), the value at the end that is kept because the sign has not
; changed, by the rule FALSI.
        .macro  keep_end name
        .if     FALSI == ILLINOIS
        MPYS    q_fa, q_half, q_fa
        .elseif FALSI == PAPER
        IBXEQ   q_kept, r0, r0, \name\()_kept_once
        MPYS    q_fa, q_half, q_fa
\name\()_kept_once:
        ES      q_kept, 1
        .elseif FALSI == PEGASUS
        ADDN    q_fb, q_fx, q_u
        DIVS    q_fb, q_u, q_u
        MPYS    q_fa, q_u, q_fa
        .elseif FALSI == ANDERSON_BJORCK
        DIVS    q_fx, q_fb, q_u
        SUBN    q_one, q_u, q_u
        CFPLT   r0, q_u, \name\()_scaled
        RTOR    q_half, q_u
\name\()_scaled:
        MPYS    q_fa, q_u, q_fa
        .endif
        .endm

        .macro  refine name, value, close
\name:
        ES      q_steps, 0
\name\()_bracket:
        MPYS    q_a, q_b, q_t
        ABS     q_a, q_s
        ABS     q_b, q_d
        CFPGE   r0, q_t, \name\()_narrow
        MPYS    q_s, q_wide, q_u
        MPYS    q_d, q_wide, q_w
        CFPLT   q_u, q_d, \name\()_wide
        CFPLT   q_w, q_s, \name\()_wide
\name\()_narrow:
        SUBN    q_b, q_a, q_w
        .if     FALSI == PAPER
        ES      q_kept, 0
        .endif
\name\()_step:
        SUBN    q_fb, q_fa, q_s
        ABS     q_b, q_d
        MPYS    q_d, \close, q_d
        DIVS    q_fb, q_s, q_s
        ADDN    q_d, q_resolution, q_d
\name\()_move:
        MPYS    q_w, q_s, q_s
        ABS     q_s, q_t
        CFPLT   q_t, q_d, \name\()_short
\name\()_long_enough:
        SUBN    q_b, q_s, q_x
        \value  q_x, q_fx
        CFPGE   q_fx, r0, \name\()_positive
        CFPGE   q_fb, r0, \name\()_change
        BIM     \name\()_keep
\name\()_positive:
        CFPGE   q_fb, r0, \name\()_keep
\name\()_change:
        RTOR    q_b, q_a
        RTOR    q_fb, q_fa
        .if     FALSI == PAPER
        ES      q_kept, 0
        .endif
        BIM     \name\()_moved
\name\()_keep:
        keep_end \name
\name\()_moved:
        SUBN    q_x, q_a, q_w
        RTOR    q_x, q_b
        RTOR    q_fx, q_fb
        CFPEQ   q_fb, r0, \name\()_found
        ABS     q_w, q_t
        CFPGE   q_d, q_t, \name\()_found
        IBXLT   q_steps, q_index_one, q_falsi_steps, \name\()_step, q_steps
        IBXLT   q_steps, r0, q_all_steps, \name\()_midpoint
\name\()_found:
\name\()_left:
        ABS     q_fa, q_s
        ABS     q_fb, q_t
        RTOR    q_a, q_answer
        CFPLT   q_s, q_t, \name\()_end
        RTOR    q_b, q_answer
\name\()_end:
        BIM     0, q_link

\name\()_midpoint:
        ABS     q_b, q_d
        MPYS    q_d, \close, q_d
        RTOR    q_half, q_s
        ADDN    q_d, q_resolution, q_d
        BIM     \name\()_move

\name\()_short:
        MPYS    q_d, q_least, q_s
        CFPGE   q_w, r0, \name\()_long_enough
        SUBN    r0, q_s, q_s
        BIM     \name\()_long_enough

\name\()_wide:
        SQRT    q_t, q_x
        CFPGE   q_a, r0, \name\()_right
        SUBN    r0, q_x, q_x
\name\()_right:
        \value  q_x, q_fx
        CFPGE   q_fx, r0, \name\()_above
        CFPGE   q_fb, r0, \name\()_move_a
\name\()_move_b:
        RTOR    q_x, q_b
        RTOR    q_fx, q_fb
        BIM     \name\()_bracket
\name\()_above:
        CFPGE   q_fb, r0, \name\()_move_b
\name\()_move_a:
        RTOR    q_x, q_a
        RTOR    q_fx, q_fa
        BIM     \name\()_bracket
        .endm
