; steiner_patch_vector.s - the vector form of the Steiner patch.

; The patch's table.
        .share  shape
        .regs   r40, kx0, ky0, kz0, kx1, ky1, kz1, kx2, ky2, kz2, kx3, ky3, kz3
        .regs   r52, kx4, ky4, kz4, kx5, ky5, kz5
        .regs   r58, kw0, kw1, kw2, kw3, kw4, kw5
        .regs   r64, other_x, other_y, other_z
        .endshare

        .reg    patch_link, r132
        .share  phase
        .regs   r168, patch_low, patch_high
        .regs   r196, candidate_s, candidate_t          ; descriptors
        .reg    candidate_routine, r198
        .endshare
        .regs   e7, temp0, temp1, temp2, temp3, temp4, temp5
        .reg    temp6, f0
        .regs   e5, g0, g1
        .regs   f1, g2, g3
        .regs   s2, parallel_limit, spread_limit
        .reg    patch_half, half
        .reg    root_s, root0

        .macro  load_patch
        set_more_lanes m
        RTOR    sh4, parallel_limit
        RTOR    sh5, spread_limit
        load_field P_TABLE, shape_at
        load_from shape_at, PATCH_TABLE, kx0
        .endm

; Replaces n2 in the lanes with spread <= e3.
        .macro  other_plane
        CMPGEV  [e3], [spread], [hits0]
        skip_empty hits0, planes_found\@
        cross_constant near_dx, near_dy, near_dz, other_x, other_y, other_z, e0, e1, e2, temp0
        VTOV    [e0], [n2x] ? [hits0]
        VTOV    [e1], [n2y] ? [hits0]
        VTOV    [e2], [n2z] ? [hits0]
        dot_vectors n2x, n2y, n2z, n2x, n2y, n2z, spread, temp0
planes_found\@:
        .endm

; Subtracts no Ki.w from `count` coefficients of a conic; no = n . o.
        .macro  lower_conic c, no, count
        .rept   \count
        ray_minus_scaled \c\+, \no, kw\+, \c\+
        .endr
        .endm

; c = 2 a b; the scalar form computes a b first and doubles it later.
        .macro  to_double a, b, c
        ray_product_double \a, \b, \c
        .endm

        no_code doubled

; hits0 = all Bernstein coefficients of R (k0, e0-e3) exceed the rounding
; errors; hits1 = all are below the negative of these.
        .macro  bernstein_sign c
        keep_where CMPLTV, [e4], [\c], hits0, hits2
        keep_where CMPLTV, [\c], [e5], hits1, hits2
        .endm

; Branches to miss if this is so for no ray.
        .macro  bernstein_signs miss
        load_words patch_numbers, 3, s3, s2     ; 1/4, 1/6, noise
        ADDNV   |[k0]|, |[k1]|, [e4]
        ADDNV   |[k2]|, [e4], [e4]
        ADDNV   |[k3]|, [e4], [e4]
        LINKV
        ADDNV   |[k4]|, [e4], [e4]
        MPYSV   [e4], s5, [e4]
        MPYSV   [k1], s3, [e5]
        MPYSV   [k2], s4, [e6]
        MPYSV   [k3], s3, [e7]
        ADDNV   [k0], [e5], [e0]
        ADDNV   [e5], [e6], [e8]
        ADDNV   [e0], [e8], [e1]
        ADDNV   [e8], [e6], [e8]
        ADDNV   [e8], [e7], [e8]
        ADDNV   [e1], [e8], [e2]
        ADDNV   [k0], [k1], [e3]
        ADDNV   [e3], [k2], [e3]
        ADDNV   [e3], [k3], [e3]
        ADDNV   [e3], [k4], [e3]
        VTOV    -[e4], [e5]
        CMPLTV  [e4], [k0], [hits0]
        CMPLTV  [k0], [e5], [hits1]
        bernstein_sign e0
        bernstein_sign e1
        bernstein_sign e2
        bernstein_sign e3
        ORB     [hits0], [hits1], [hits0]
        CNTOB   [hits0], s0
        IBXEQ   s0, r0, m, \miss
        .endm

        .macro  patch_coordinate k0, k1, k2, k3, k4, k5, sum
        ray_line candidate_s, \k1, \k0, \sum
        patch_part candidate_t, \k2, \sum
        patch_part e4, \k3, \sum
        patch_part e5, \k4, \sum
        patch_part e6, \k5, \sum
        .endm

        .macro  patch_part power, k, sum
        LINKV
        MPYSV   [\power], \k, [temp0]
        ADDNV   [temp0], [\sum], [\sum]
        .endm

        .macro  keep_in_triangle none
        keep_not_less_number candidate_t, patch_low, hits2, \none, hits3
        ADDNV   [candidate_s], [candidate_t], [e3]
        keep_number_not_less patch_high, e3, hits2, \none, hits3
        skip_empty hits2, \none
        MPYSV   [candidate_s], [candidate_s], [e4]
        MPYSV   [candidate_s], [candidate_t], [e5]
        MPYSV   [candidate_t], [candidate_t], [e6]
        .endm

        .macro  keep_ahead none
        keep_where CMPLTV, [lane_low], [e3], hits2, hits3
        .endm

; Replaces tin by the candidates that are nearer.
        .macro  patch_candidate rational
        patch_distance \rational, candidate_none\@
        VXTOV   [lane_at], [tin], [e4]
        keep_where CMPLTV, [e3], [e4], hits2, hits3
        VTOVX   [lane_at], [e3], [tin] ? [hits2]
        VTOVX   [lane_at], [candidate_s], [patch_s] ? [hits2]
        VTOVX   [lane_at], [candidate_t], [patch_t] ? [hits2]
candidate_none\@:
        BIM     0, patch_link
        .endm

; Appends every candidate to the next of its ray's vectors, while there are any.
; lane_at then is the ray's index in the vector after that.
        .macro  patch_crossing rational
        patch_distance \rational, crossing_none\@
        EX      s0, PATCH_CROSSINGS * QUEUE
        keep_where CMPLTV, [lane_at], s0, hits2, hits3
        VTOVX   [lane_at], [e3], [tin] ? [hits2]
        VTOVX   [lane_at], [candidate_s], [patch_s] ? [hits2]
        VTOVX   [lane_at], [candidate_t], [patch_t] ? [hits2]
        EX      s0, QUEUE
        ADDXV   [lane_at], s0, [lane_at] ? [hits2]
crossing_none\@:
        BIM     0, patch_link
        .endm

        .macro  enter_patch routine, wanted
        EX      candidate_routine, \routine
        VTOV    big, [tin]
        load_record P_SHAPE, 6, sh0
        .if     \wanted
        VTOV    big, [tout]
        VTOV    big, [tin2]
        VTOV    big, [tout2]
        .else
        VTOV    minus_big, [tout]
        .endif
        .endm

        .macro  solve_patch
        load_words patch_limits, 3, s7, s2      ; low, high, resolution
        RTOR    s7, patch_low
        RTOR    s8, patch_high
        VTOV    patch_low, [e0]
        VTOV    patch_high, [e1]
        VTOV    patch_low, [e1] ? [hits0]       ; no interval: no root
        solve_quartics solve_quartic_all, e0, e1, s9
        .endm

; Keeps only the lanes of hits0.
        .macro  keep vector
        CPSV    [\vector], [\vector] ? [hits0]
        .endm

        .macro  begin_root done
        CMPLTV  r0, [root_count], [hits0]
        if_none hits0, s2, \done
        IBXEQ   s2, r0, m, root_taken\@
        RTOR    s2, m
        keep    lane_at
        keep    lane_dx
        keep    lane_dy
        keep    lane_dz
        keep    lane_along
        keep    lane_low
        .rept   6
        keep    pa\+
        .endr
        .rept   5
        keep    pb\+
        .endr
        keep    spread
        .rept   4
        keep    root\+
        .endr
        keep    root_count
        set_lanes m
        set_more_lanes m
root_taken\@:
        .endm

; hits2 = the lanes in which t = -B0(s)/B(s), hits1 = the others.
        .macro  test_root lines
        DIVSV   -[e0], [e1], [e2]
        CMPGEV  [spread], [temp0], [hits0]
        CMPGEV  [spread], [temp1], [hits1]
        ANDB    [hits0], [hits1], [hits1]       ; both nearly 0
        NANDB   [hits1], [hits1], [hits2]
        RTOR    root0, candidate_s
        RTOR    e2, candidate_t
        BSAVE   patch_link, [candidate_routine]
        CNTOB   [hits1], s2
        IBXNE   s2, r0, r0, \lines
        .endm

; Advances to the next root: rotates the vectors and decrements the count.
        .macro  next_root
        RTOR    root0, s2
        RTOR    root1, root0
        RTOR    root2, root1
        RTOR    root3, root2
        RTOR    s2, root3
        SUBNV   [root_count], one, [root_count]
        .endm

        .macro  leave_patch done, miss
\done:
        IBXNE   segments_wanted, r0, one_index, \miss
        CMPLTV  [tin], big, [bits0]
        VTOV    [tin], [tout] ? [bits0]
\miss:
        BIM     0, link_kernel
        .endm

        .macro  first_candidate
        quadratic_roots pa5, e1, e0, temp0, f0, f1
        ANDB    [hits1], [bits0], [hits1]
        line_candidate f0
        .endm

        .macro  second_candidate
        line_candidate f1
        .endm

        .macro  line_candidate t
        RTOR    \t, candidate_t
        RTOR    f2, candidate_s
        VTOV    [root0], [f2]
        .endm

; hits2 = the lanes of hits1 in which Newton's method has converged, s inside.
        .macro  leave_newton
        load_word patch_numbers + 64 * 3, s2
        ADDNV   |[e0]|, |[e1]|, [e0]
        CMPLTV  [e0], s2, [hits2]
        ANDB    [hits1], [hits2], [hits2]
        keep_not_less_number candidate_s, patch_low, hits2, newton, hits3
        BIM     0, candidate_routine
        .endm
