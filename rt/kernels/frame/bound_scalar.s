; bound_scalar.s - does a ray come near a bounding sphere?
;
; Centre C, radius R, limit of the ray.  With L = C - O, b = L . D:
;
;   near:  L . L - b^2 <= R^2   and   b + R > 0   and   b - R < limit
;
; The radius has been enlarged by the host, and L.L counts for a little less, as
; in bound_vector.s; so what is near enough to be hit is near.  R = big: no
; bound.  The products do not wait for each other; the distance, which takes
; longest, is asked last.
;
; The ray, the limit and the work are in the registers of those that walk
; through the regions.
; Source: bound_vector.s.

        .share  local
        .regs   r32, w_ray, w_argument, w_result_at
        .regs   r35, w_link, w_back, w_at, w_met
        .regs   r39, w_region, w_regions_left
        .regs   r41, w_ox, w_oy, w_oz, w_dx, w_dy, w_dz, w_lower
        .regs   r48, w_limit, w_leaf
        .regs   r50, w_cx, w_cy, w_cz, w_radius, w_square, w_simple, w_shadow
        .regs   r57, w_nodes, w_nodes_end, w_first
        .equ    REGION_LOADED, R_FIRST + 1
        .regs   r60, w_two_delta, w_less
        .regs   r62, n_cx, n_cy, n_cz, n_radius, n_square, n_steps
        .regs   r68, n_step_count, n_primitive, n_needed, n_next, n_value
        .equ    NODE_LOADED, N_VALUE + 1
        .regs   r73, w_chain, w_branch, w_node, l_crossing, w_least, w_end
        .regs   r79, w_t0, w_t1, w_t2, w_t3, w_t4, w_t5, w_t6
        .regs   r86, w_in, w_out, w_stack
        .endshare
        .equ    WALK_REGISTERS, 57

; A leaf's part in its tree, in the place of its bound.
        .share  local
        .regs   r62, l_state_kernel, l_state_inner, l_at_hand, l_segments
        .regs   r66, l_events, l_first_state, l_first_event
        .endshare

        .macro  skip_far c0, c1, c2, radius, square, limit, far
        CFPGE   \radius, m_big, near\@
        SUBN    \c0, w_ox, w_t0
        SUBN    \c1, w_oy, w_t1
        SUBN    \c2, w_oz, w_t2
        MPYS    w_t0, w_dx, w_t3
        MPYS    w_t1, w_dy, w_t4
        MPYS    w_t2, w_dz, w_t5
        MPYS    w_t0, w_t0, w_t0
        MPYS    w_t1, w_t1, w_t1
        MPYS    w_t2, w_t2, w_t2
        ADDN    w_t4, w_t3, w_t3
        ADDN    w_t1, w_t0, w_t0
        ADDN    w_t5, w_t3, w_t3
        ADDN    w_t2, w_t0, w_t0
        ADDN    w_t3, \radius, w_t4
        SUBN    w_t3, \radius, w_t5
        MPYS    w_t0, w_less, w_t0
        MPYS    w_t3, w_t3, w_t6
        CFPGE   r0, w_t4, \far
        SUBN    w_t0, \square, w_t0
        CFPGE   w_t5, \limit, \far
        CFPLT   w_t6, w_t0, \far
near\@:
        .endm
