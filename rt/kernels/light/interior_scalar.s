; interior_scalar.s - computes the bodies that contain a ray.  The formulas are
; in interior.s, the order of the operations is that of interior_vector.s.
; These macros are a part of SPAWN (spawn_scalar.s).

        .share  local
        .regs   r80, in_table, in_base, in_per_base, in_full, in_per_full
        .regs   r85, in_levels, in_body, in_scale, in_under, in_last, in_rest
        .reg    in_mirror, r91
        .endshare

; In:  sp_own_inside = S, sp_outward; in_table .., in_body.
; Out: sp_own_inside, known; sp_inside = S', sp_e = e; in_mirror = w.
        .macro  find_interiors
        CFPGE   sp_own_inside, r0, interiors_known
        ES      sp_flag, 0
        CFPGE   sp_outward, r0, interiors_side
        ES      sp_flag, 1
interiors_side:
        RTOR    m_zero, sp_own_inside
        IBXNE   sp_flag, r0, sp_inverted, interiors_known
        RTOR    in_body, sp_own_inside
interiors_known:
        last_of sp_own_inside, in_under, in_last
        CFPEQ   in_last, in_body, interiors_left
        RTOR    in_under, in_rest
        RTOR    in_base, in_scale
interiors_deeper:
        CFPEQ   in_rest, r0, interiors_new
        last_of in_rest, sp_t0, sp_t1
        CFPEQ   sp_t1, in_body, interiors_within
        RTOR    sp_t0, in_rest
        MPYS    in_scale, in_base, in_scale
        BIM     interiors_deeper
interiors_within:
        .if     GLOSS
        index_of in_last, sp_e
        DIVS    sp_e, sp_index, in_mirror
        .endif
        SUBN    sp_t0, in_rest, sp_t0
        MPYS    sp_t0, in_scale, sp_t0
        ADDN    sp_t0, sp_own_inside, sp_inside
        RTOR    m_one, sp_e
        BIM     interiors_found
interiors_left:
        .if     GLOSS
        RTOR    sp_reciprocal, in_mirror
        CFPEQ   in_under, r0, interiors_alone
        index_of in_last, sp_e
        DIVS    sp_e, sp_index, in_mirror
interiors_alone:
        .endif
        RTOR    in_under, sp_inside
        last_of in_under, sp_t0, sp_t1
        index_of sp_t1, sp_t1
        DIVS    sp_index, sp_t1, sp_e
        BIM     interiors_near
interiors_new:
        index_of in_last, sp_t1
        DIVS    sp_t1, sp_index, sp_e
        .if     GLOSS
        DIVS    sp_index, sp_t1, in_mirror
        .endif
        RTOR    sp_own_inside, sp_t0
        CFPEQ   in_full, r0, interiors_limit
        drop_first sp_own_inside, sp_t0
interiors_limit:
        line    sp_t0, in_base, in_body, sp_inside
interiors_near:
        SUBN    sp_e, m_one, sp_t0
        CFPGE   sp_t0, m_checker_shift, interiors_found
        SUBN    m_one, sp_e, sp_t0
        CFPGE   sp_t0, m_checker_shift, interiors_found
        RTOR    m_one, sp_e
interiors_found:
        .endm
