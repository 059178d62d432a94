; steiner_implicit_vector.s - the vector form of the implicit Steiner patch.
; Rays through T are counted.  If there are none, they cost nothing.

        .share  shape
        .regs   r40, la00, la01, la02, la03, la10, la11, la12, la13
        .regs   r48, la20, la21, la22, la23
        .regs   r52, lb00, lb01, lb02, lb03, lb10, lb11, lb12, lb13
        .regs   r60, lb20, lb21, lb22, lb23
        .regs   r64, triple_x, triple_y, triple_z, triple_w
        .endshare
        .share  shape
        .regs   r40, qxss, qxtt, qxuu, qxst, qxtu, qxus
        .regs   r46, qyss, qytt, qyuu, qyst, qytu, qyus
        .regs   r52, qzss, qztt, qzuu, qzst, qztu, qzus
        .regs   r58, qwss, qwtt, qwuu, qwst, qwtu, qwus
        .endshare

        .regs   pa0, ma0, ma1, ma2, da0, da1, da2, mb0, mb1, mb2, db0, db1
        .regs   n1x, db2, c00, c01, c02, c10, c11, c12, c20, c21, c22
        .regs   pa0, fss, ftt, fuu, fst, ftu, fus      ; A, used after these
        .regs   pa0, found_s, found_t                  ; used after A
        .regs   e0, plane_x, plane_y, plane_z, plane_o, form0, form1, form2

        .share  phase
        .reg    through_count, r189
        .reg    other_kernel, r196
        .reg    link_through, r188
        .endshare

        .data
; One word per ray of the queue: 1 if the ray does not pass through T, else 0;
; then its tin, patch_s and patch_t.
through_store:  .space 4 * QUEUE
        .code

        .macro  through_vectors
        describe s2, through_store, near
        address_of s2, QUEUE, s3
        address_of s3, QUEUE, s4
        address_of s4, QUEUE, s5
        .endm

        .macro  minus_scaled_three a, f0, k0, f1, k1, f2, k2
        ray_minus_scaled \f0, \a, \k0, \f0
        ray_minus_scaled \f1, \a, \k1, \f1
        ray_minus_scaled \f2, \a, \k2, \f2
        .endm

        .macro  dot_rows_of x0, x1, x2, a0, a1, a2, b0, b1, b2, c0, c1, c2, a, b, c
        dot_vectors \x0, \x1, \x2, \a0, \a1, \a2, \a, temp0
        dot_vectors \x0, \x1, \x2, \b0, \b1, \b2, \b, temp0
        dot_vectors \x0, \x1, \x2, \c0, \c1, \c2, \c, temp0
        .endm

; Computes p at the roots q_t of the lanes q_at.
        .macro  parameter_at c0, c1, c2, p
        lengthen q_u, \p
        VXTOV   [q_at], [\c2], [\p]
        MPYSV   [\p], [q_t], [\p]
        VXTOV   [q_at], [\c1], [q_d]
        ADDNV   [\p], [q_d], [\p]
        MPYSV   [\p], [q_t], [\p]
        VXTOV   [q_at], [\c0], [q_d]
        ADDNV   [\p], [q_d], [\p]
        .endm

        .macro  enter_implicit
        load_record P_SHAPE, 6, sh0
        .endm

        .macro  load_planes
        set_more_lanes m
        load_word implicit_numbers + 64 * 2, s2
        MPYS    sh3, s2, s2
        load_field P_TABLE, shape_at
        IX      shape_at, 64 * PATCH_TABLE
        load_from shape_at, PLANES_TABLE, la00
        .endm

        no_code load_margins

        .macro  leave_through label
        CMPGEV  s2, [form0], [hits0]
        if_none hits0, through_count, implicit_form
        VTOV    [lane_low], [lane_high] ? [hits0]       ; no interval: no root
implicit_form:
        IX      shape_at, 64 * PLANES_TABLE
        load_from shape_at, FORMS_TABLE, qxss
        .endm

; The other kernel processes the whole queue.  Then all rays except those
; through T get their previous results back.
        .macro  leave_implicit through, miss
        load_record P_SHAPE + 6, 1, s9          ; resolution
        EX      s8, implicit_accept
        solve_lanes s9, solve_quartic_until
        VTOVX   [lane_at], [found_s], [patch_s] ? [hits0]
        VTOVX   [lane_at], [found_t], [patch_t] ? [hits0]
        IBXNE   through_count, r0, r0, \through
        BIM     0, link_kernel
\miss:
        miss_near
\through:
        through_vectors
        CMPLTV  [lane_low], [lane_high], [hits0]
        VTOV    one, [s2]
        VTOVX   [lane_at], r0, [s2] ?! [hits0]
        VTOV    [tin], [s3]
        VTOV    [patch_s], [s4]
        VTOV    [patch_t], [s5]
        RTOR    link_kernel, link_through
        BSAVE   link_kernel, [other_kernel]
        RTOR    link_through, link_kernel
        through_vectors
        CMPEQV  [s2], one, [bits0]
        VTOV    [s3], [tin] ? [bits0]
        VTOV    [s4], [patch_s] ? [bits0]
        VTOV    [s5], [patch_t] ? [bits0]
        VTOV    minus_big, [tout]
        BIM     steiner_done
        .endm

; Accepts the roots whose parameters are in the triangle.
        .macro  accept_implicit
implicit_accept:
        lengthen q_u, q_d
        lengthen q_u, q_s
        lengthen q_u, q_change
        parameter_at c00, c10, c20, q_a
        parameter_at c01, c11, c21, q_b
        parameter_at c02, c12, c22, q_x
        ADDNV   [q_a], [q_b], [q_s]
        ADDNV   [q_s], [q_x], [q_s]
        DIVSV   [q_a], [q_s], [q_a]             ; s
        DIVSV   [q_b], [q_s], [q_b]             ; t
        load_words implicit_numbers, 2, s3, s2
        CMPGEV  [q_a], s3, [q_bits]
        keep_where CMPGEV, [q_b], s3, q_bits, q_change
        ADDNV   [q_a], [q_b], [q_s]
        keep_where CMPGEV, s4, [q_s], q_bits, q_change
        VTOVX   [q_at], [q_a], [found_s] ? [q_bits]
        VTOVX   [q_at], [q_b], [found_t] ? [q_bits]
        BIM     0, s9
        .endm
