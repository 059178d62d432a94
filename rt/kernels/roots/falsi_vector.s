; falsi_vector.s - refines the roots of many polynomials, each between two ends
; with different signs.  The macro
;
;       refine  NAME, value, compress, close
;
; makes the routine NAME for one degree, called by BSAVE q_link.  The macro
; value x, fx evaluates the polynomials, compress bits compresses their
; coefficients; close is the closeness.
;
; The two ends are A and B, B the newer one.  0 is positive.
;
; 1. While both ends have the same sign and one is more than twice the other,
;    the bracket is bisected in the exponent: X = sqrt(A B).
; 2. Steps of regula falsi: X = B - (B - A) f(B) / (f(B) - f(A)), but at least
;    7/8 D from B, where D = closeness |B| + resolution.  If the sign has
;    changed from B to X, A := B; else f(A) is reduced (quartic_constants.s).  B
;    := X.
; 3. The root is found when |B - A| <= D or f(B) = 0: it is the end with the
;    smaller |f|.  So the sign of f changes within D of every root.
; 4. A bracket that is not finished after FALSI_STEPS such steps is bisected,
;    X = (A + B) / 2, at most HALVINGS times.
;
; The loop runs over all lanes; an answer is kept once it is found.  When fewer
; than half of the lanes in the loop are active, the answers of the others are
; scattered and the active ones compressed.
;
; In:  q_a, q_fa, q_b, q_fb, the coefficients, q_at (indices of the lanes), all
;      as long as the number of lanes; q_resolution; q_result.
; Out: the roots, scattered by q_at into q_result.
; Changes q_x, q_fx, q_w, q_s, q_d, q_t, q_answer and the bit vectors named
; here.

; Sets the length of a descriptor; the address does not change.
        .macro  lengthen count, vector
        ELEN    \vector, 0
        ADDLEN  \vector, \count, \vector
        .endm

        .macro  exchange a, b
        RTOR    \a, q_u
        RTOR    \b, \a
        RTOR    q_u, \b
        .endm

        .macro  set_loop
        .rept   7
        lengthen q_loop, loop\+
        .endr
        .rept   5 + (FALSI == PAPER)
        lengthen q_loop, loop_bits\+
        .endr
        .endm

; Reduces f(A) in the lanes in which A is kept, because the sign has not
; changed.
        .macro  keep_ends
        .if     FALSI == ILLINOIS
        MPYSV   [q_fa], q_half, [q_fa] ?! [q_change]
        .elseif FALSI == PAPER
        ORB     [q_change], [q_changed], [q_bits]
        MPYSV   [q_fa], q_half, [q_fa] ?! [q_bits]
        ANDB    [q_change], [q_change], [q_changed]
        .elseif FALSI == PEGASUS
        ADDNV   [q_fb], [q_fx], [q_t]
        DIVSV   [q_fb], [q_t], [q_t]
        MPYSV   [q_fa], [q_t], [q_fa] ?! [q_change]
        .elseif FALSI == ANDERSON_BJORCK
        LINKV
        DIVSV   [q_fx], [q_fb], [q_t]
        SUBNV   q_one, [q_t], [q_t]
        CMPLTV  r0, [q_t], [q_bits]
        VTOV    q_half, [q_t] ?! [q_bits]
        MPYSV   [q_fa], [q_t], [q_fa] ?! [q_change]
        .endif
        .endm

        .macro  refine name, value, compress, close
\name:
        LTOR    q_at, q_loop
        RTOR    q_loop, q_active_count
        set_loop
        lengthen q_loop, q_b_sign
        lengthen q_loop, q_active
        CMPGEV  [q_fb], r0, [q_b_sign]
        EQVB    [q_b_sign], [q_b_sign], [q_active]

; Bisects wide brackets in the exponent.
\name\()_bracket:
        MPYSV   [q_a], [q_b], [q_w]
        MPYSV   |[q_a]|, q_wide, [q_s]
        MPYSV   |[q_b]|, q_wide, [q_d]
        CMPLTV  [q_s], |[q_b]|, [q_small]
        CMPLTV  [q_d], |[q_a]|, [q_bits]
        ORB     [q_small], [q_bits], [q_small]
        keep_where CMPLTV, r0, [q_w], q_small, q_bits
\name\()_wide:
        if_none q_small, q_finished, \name\()_narrow
        SQRTV   [q_w], [q_x] ? [q_small]
        CMPLTV  [q_a], r0, [q_bits]
        VTOV    -[q_x], [q_x] ? [q_bits]
        \value  q_x, q_fx
        CMPGEV  [q_fx], r0, [q_x_sign]
        XORB    [q_x_sign], [q_b_sign], [q_change]
        ANDNB   [q_small], [q_change], [q_bits]
        VTOV    [q_x], [q_b] ? [q_bits]
        VTOV    [q_fx], [q_fb] ? [q_bits]
        ANDB    [q_small], [q_change], [q_bits]
        VTOV    [q_x], [q_a] ? [q_bits]
        VTOV    [q_fx], [q_fa] ? [q_bits]
        BIM     \name\()_bracket

\name\()_narrow:
        .if     FALSI == PAPER
        EQVB    [q_b_sign], [q_b_sign], [q_changed]
        .endif
        SUBNV   [q_b], [q_a], [q_w]
        ES      q_steps, 0
\name\()_step:
        SUBNV   [q_fb], [q_fa], [q_s]
        DIVSV   [q_fb], [q_s], [q_s]
        MPYSV   [q_w], [q_s], [q_s]
        BIM     \name\()_move
\name\()_midpoint:
        MPYSV   [q_w], q_half, [q_s]
\name\()_move:
        LINKV
        MPYSV   |[q_b]|, \close, [q_d]
        ADDNV   [q_d], q_resolution, [q_d]
        CMPLTV  |[q_s]|, [q_d], [q_small]
        if_none q_small, q_finished, \name\()_long_enough
        MPYSV   [q_d], q_least, [q_s] ? [q_small]
        CMPLTV  [q_w], r0, [q_bits]
        ANDB    [q_small], [q_bits], [q_bits]
        VTOV    -[q_s], [q_s] ? [q_bits]
\name\()_long_enough:
        SUBNV   [q_b], [q_s], [q_x]
        \value  q_x, q_fx
        CMPGEV  [q_fx], r0, [q_x_sign]
        XORB    [q_x_sign], [q_b_sign], [q_change]
        keep_ends
        VTOV    [q_b], [q_a] ? [q_change]
        VTOV    [q_fb], [q_fa] ? [q_change]
        exchange q_b, q_x
        exchange q_fb, q_fx
        exchange q_b_sign, q_x_sign
        SUBNV   [q_b], [q_a], [q_w]
        CMPGEV  [q_d], |[q_w]|, [q_done]
        CMPEQV  [q_fb], r0, [q_bits]
        ORB     [q_done], [q_bits], [q_done]
        ANDB    [q_done], [q_active], [q_done]
        CNTOB   [q_done], q_finished
        IBXNE   q_finished, r0, r0, \name\()_found
\name\()_next:
        IBXLT   q_steps, q_index_one, q_falsi_steps, \name\()_step, q_steps
        IBXLT   q_steps, r0, q_all_steps, \name\()_midpoint
        ANDB    [q_active], [q_active], [q_done]
        RTOR    q_active_count, q_finished
\name\()_found:
        CMPLTV  |[q_fa]|, |[q_fb]|, [q_bits]
        VTOV    [q_b], [q_answer] ? [q_done]
        ANDB    [q_bits], [q_done], [q_bits]
        VTOV    [q_a], [q_answer] ? [q_bits]
\name\()_left:
        SUBX    q_active_count, q_finished, q_active_count
        IBXEQ   q_active_count, r0, r0, \name\()_end
        ANDNB   [q_active], [q_done], [q_active]
        ADDX    q_active_count, q_active_count, q_u
        IBXGE   q_u, r0, q_loop, \name\()_next

; Compresses the loop: fewer than half of its lanes are active.
        CPSV    [q_answer], [q_x] ?! [q_active]
        CPSV    [q_at], [q_fx] ?! [q_active]
        VTOVX   [q_fx], [q_x], [q_result]
        CPSV    [q_at], [q_at] ? [q_active]
        CPSV    [q_a], [q_a] ? [q_active]
        CPSV    [q_fa], [q_fa] ? [q_active]
        CPSV    [q_b], [q_b] ? [q_active]
        CPSV    [q_fb], [q_fb] ? [q_active]
        CPSV    [q_w], [q_w] ? [q_active]
        \compress q_active
        CPSB    [q_b_sign], [q_b_sign] ? [q_active]
        .if     FALSI == PAPER
        CPSB    [q_changed], [q_changed] ? [q_active]
        .endif
        RTOR    q_active_count, q_loop
        lengthen q_loop, q_active
        EQVB    [q_active], [q_active], [q_active]
        set_loop
        BIM     \name\()_next
\name\()_end:
        VTOVX   [q_at], [q_answer], [q_result]
        BIM     0, q_link
        .endm
