; normal_vector.s - computes the normals at m points of one primitive: the part
; that all normal_NAME.s files share.
;
; In:  [qx] [qy] [qz], the points in the shape's own space; the record.
; Out: [nx] [ny] [nz], in that space, of length one, pointing outwards.
; Source: textbook; the nearest face or side is the one that a point belongs to.
; Changes v0-v7, hits0-hits3.

        .share  phase
        .regs   r185, qx, qy, qz            ; point
        .endshare

        .macro  set_points x0, x1, x2
        copy_three \x0, \x1, \x2, qx, qy, qz
        .endm

; The operations of kernels that are written once (forms.s), with the names of
; registers in the scalar form.
        .include "forms.s"
        vector_form , hits1, hits2, rest
        .share  normals
        .regs   v0, t0, t1, t2, t3, t4, t5, t6, t7
        .reg    m_zero, r0
        .reg    table, s1
        .reg    spare, s2
        .reg    rest, hits3
        .reg    point_s, cr
        .reg    point_t, cg
        .reg    m_one, one
        .reg    m_minus_one, minus_one
        .reg    m_half, half
        .reg    m_two, two
        .reg    m_tiny, tiny
        .reg    m_checker_shift, checker_shift
        .reg    m_index_one, one_index
        .endshare
        .share  scratch
        .regs   r233, row0, row1, row2, row3, row4, row5, row6, row7, row8, row9
        .regs   r243, row10, row11, row12, row13, row14, row15, row16, row17
        .endshare

        .macro  dot_product x0, x1, x2, y0, y1, y2, sum, work
        dot_vectors \x0, \x1, \x2, \y0, \y1, \y2, \sum, \work
        .endm

        .macro  dot_numbers x0, x1, x2, k0, k1, k2, sum, work
        dot_constant \x0, \x1, \x2, \k0, \k1, \k2, \sum, \work
        .endm

        .macro  matrix_times x0, x1, x2, y0, y1, y2
        times_matrix \x0, \x1, \x2, \y0, \y1, \y2, v3
        .endm

        .macro  cross_product a0, a1, a2, b0, b1, b2, c0, c1, c2
        cross   \a0, \a1, \a2, \b0, \b1, \b2, \c0, \c1, \c2, v7
        .endm

        .macro  load_point_s
        VXTOV   [at], [hit_s], [point_s]
        .endm

        .macro  load_point_t
        VXTOV   [at], [hit_t], [point_t]
        .endm

        .macro  set_big a
        set     big, \a
        .endm

        .macro  least_of a, c
        MINV    [\a], s0, \c
        .endm

        .macro  greatest_of a, c
        MAXV    [\a], s0, \c
        .endm

        .macro  skip_if_none label
        if_none hits1, s0, \label
        .endm

        .macro  leave_normal
        BIM     0, link_kernel
        .endm

        no_code leave_or
