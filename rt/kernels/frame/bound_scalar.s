; bound_scalar.s - tests whether a ray comes near a bounding sphere.
;
; bound_vector.s gives the formula and its source. R = big: no bound. The
; products do not depend on each other. The distance takes longest, so it is
; tested last.
;
; The ray, the limit and the temporaries are in the registers of the routines
; that walk through the regions.

        .share  local
        .regs   r32, w_ray, w_argument, w_result_at
        .regs   r35, w_link, w_back, w_at, w_hit
        .regs   r39, w_region, w_regions_left
        .regs   r41, w_ox, w_oy, w_oz, w_dx, w_dy, w_dz, w_lower
        .regs   r48, w_limit, w_leaf
        .regs   r50, w_cx, w_cy, w_cz, w_radius, w_square, w_flags, w_shadow
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

; A leaf's fields in its tree, in the registers of its bound.
        .share  local
        .regs   r62, l_state_kernel, l_state_inner, l_next_hit, l_segments
        .regs   r66, l_events, l_first_state, l_first_event
        .endshare

        .macro  skip_far c0, c1, c2, radius, square, limit, far
        CFPGE   \radius, m_big, near\@
        three   SUBN, \c0, \c1, \c2, w_ox, w_oy, w_oz, w_t0, w_t1, w_t2
        three   MPYS, w_t0, w_t1, w_t2, w_dx, w_dy, w_dz, w_t3, w_t4, w_t5
        three   MPYS, w_t0, w_t1, w_t2, w_t0, w_t1, w_t2, w_t0, w_t1, w_t2
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

; Tests the ray against a region's box as well (miss_box_vector.s).
        .share  local
        .regs   r62, b_cx, b_cy, b_cz, b_hx, b_hy, b_hz, b_dx, b_dy, b_dz
        .reg    b_lost, r71
        .endshare

        .macro  skip_if_separated c1, c2, d1, d2, h1, h2, a1, a2, box_missed
        MPYS    \c1, \d2, w_t0
        MPYS    \c2, \d1, w_t1
        MPYS    \h1, \a2, w_t2
        MPYS    \h2, \a1, w_t3
        SUBN    w_t0, w_t1, w_t0
        ADDN    w_t2, w_t3, w_t2
        ABS     w_t0, w_t0
        CFPLT   w_t2, w_t0, \box_missed
        .endm

        .macro  skip_if_box_missed box_missed
        load_part w_region, R_BOX, 6, b_cx, w_at
        load_word bound_lost, b_lost
        three   SUBN, b_cx, b_cy, b_cz, w_ox, w_oy, w_oz, b_cx, b_cy, b_cz
        ABS     w_dx, b_dx
        ABS     w_dy, b_dy
        ABS     w_dz, b_dz
        ABS     b_cx, w_t0
        ABS     b_cy, w_t1
        ABS     b_cz, w_t2
        three_by MPYS, b_lost, w_t0, w_t1, w_t2, w_t0, w_t1, w_t2
        three   ADDN, b_hx, b_hy, b_hz, w_t0, w_t1, w_t2, b_hx, b_hy, b_hz
        skip_if_separated b_cy, b_cz, w_dy, w_dz, b_hy, b_hz, b_dy, b_dz, \box_missed
        skip_if_separated b_cz, b_cx, w_dz, w_dx, b_hz, b_hx, b_dz, b_dx, \box_missed
        skip_if_separated b_cx, b_cy, w_dx, w_dy, b_hx, b_hy, b_dx, b_dy, \box_missed
        .endm

; Branches for a region that is not only simple: to `tree` if it has no box, to
; `box_missed` if the ray misses the box, to `simple` if it is simple with a
; box. Otherwise continues: a tree in its box.
        .macro  test_box tree, simple, box_missed
        IBXEQ   w_flags, r0, r0, \tree
        skip_if_box_missed \box_missed
        ES      w_at, REGION_BOXED
        IBXNE   w_flags, r0, w_at, \simple
        .endm
