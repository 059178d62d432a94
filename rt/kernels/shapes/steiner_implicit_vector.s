; steiner_implicit_vector.s - intersects a queue of rays with a Steiner patch by
; the quartic of the surface that contains it: the method of 1984, for
; comparison.
;
; The surface H(p), p = (s, t, u), has two moving planes: matrices L1, L2 with
;   p . (L1 H(p)) = p . (L2 H(p)) = 0   for all p,
; A point X of it therefore has the parameters p ~ (L1 X) x (L2 X).  On a ray
; o + d tau, o its closest approach to the patch's centre, with
;
;   a = L1 (o, 1), a' = L1 (d, 0), b = L2 (o, 1), b' = L2 (d, 0):
;   p(tau) = c0 + c1 tau + c2 tau^2,
;   c0 = a x b,  c1 = a x b' + a' x b,  c2 = a' x b'
;
; All points of a plane through the ray, N . X = N . o, satisfy p A p = 0.  Here
; A = N.x Qx + N.y Qy + N.z Qz - (N . o) Qw, with the quadratic forms of H.  So
; the ray hits the surface where
;
;   c0 A c0 + 2 c1 A c0 tau + (2 c2 A c0 + c1 A c1) tau^2 + 2 c2 A c1 tau^3
;     + c2 A c2 tau^4 = 0
;
; times the distance of the triple point T from the plane.  N is perpendicular
; to d and points towards T.  The solver computes the roots in ascending order
; and passes each to a routine.  A root whose parameters are not in the
; triangle, within 2^-30, is not a crossing.
;
; The smaller N, the larger the share of rounding errors in the quartic; for a
; ray through T all coefficients are 0.  If |N|^2 <= 2^-20 bound^2 (T a vector
; of length one, in units of the bound), the errors may be 2^-27 of the quartic.
; Such rays are counted, and steiner_patch_vector.s intersects them.  If there
; are none, this costs nothing.
;
; steiner_implicit, rational_steiner_implicit: the entries select the kernel for
; such rays, steiner or rational_steiner.
; In:  ox oy oz dx dy dz lower, n long; the primitive's record and the part
;      of its table after PATCH_TABLE.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big;
;      patch_s, patch_t where there is a crossing.
; Source: the project's notes on ray tracing, 2.2 (B), which derive it; the
; paper says only that the quartic is solved.

; The rest of the table, in two parts: L1, L2 by rows, T; then the forms
; Qx Qy Qz Qw, each as ss tt uu st tu us.
        .share  shape
        .regs   r40, la00, la01, la02, la03, la10, la11, la12, la13
        .regs   r48, la20, la21, la22, la23
        .regs   r52, lb00, lb01, lb02, lb03, lb10, lb11, lb12, lb13
        .regs   r60, lb20, lb21, lb22, lb23
        .regs   r64, triple_x, triple_y, triple_z, triple_w
        .endshare
        .equ    PLANES_TABLE, 28
        .share  shape
        .regs   r40, qxss, qxtt, qxuu, qxst, qxtu, qxus
        .regs   r46, qyss, qytt, qyuu, qyst, qytu, qyus
        .regs   r52, qzss, qztt, qzuu, qzst, qztu, qzus
        .regs   r58, qwss, qwtt, qwuu, qwst, qwtu, qwus
        .endshare
        .equ    FORMS_TABLE, 24

        .regs   pa0, ma0, ma1, ma2, da0, da1, da2, mb0, mb1, mb2, db0, db1
        .regs   n1x, db2, c00, c01, c02, c10, c11, c12, c20, c21, c22
        .regs   pa0, fss, ftt, fuu, fst, ftu, fus      ; A, used after these
        .regs   pa0, found_s, found_t                  ; used after A

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
        EX      s2, through_store
        ADDLEN  s2, near, s2
        RTOR    s2, s3
        IX      s3, 64 * QUEUE
        RTOR    s3, s4
        IX      s4, 64 * QUEUE
        RTOR    s4, s5
        IX      s5, 64 * QUEUE
        .endm

        .macro  plane_row l0, l1, l2, l3, at, by
        dot_constant lane_ox, lane_oy, lane_oz, \l0, \l1, \l2, \at, e12
        ADDNV   [\at], \l3, [\at]
        dot_constant lane_dx, lane_dy, lane_dz, \l0, \l1, \l2, \by, e12
        .endm

        .macro  parameters_of_ray
        plane_row la00, la01, la02, la03, ma0, da0
        plane_row la10, la11, la12, la13, ma1, da1
        plane_row la20, la21, la22, la23, ma2, da2
        plane_row lb00, lb01, lb02, lb03, mb0, db0
        plane_row lb10, lb11, lb12, lb13, mb1, db1
        plane_row lb20, lb21, lb22, lb23, mb2, db2
        cross   ma0, ma1, ma2, mb0, mb1, mb2, c00, c01, c02, e12
        cross   ma0, ma1, ma2, db0, db1, db2, c10, c11, c12, e12
        cross   da0, da1, da2, mb0, mb1, mb2, e0, e1, e2, e12
        ADDNV   [c10], [e0], [c10]
        ADDNV   [c11], [e1], [c11]
        ADDNV   [c12], [e2], [c12]
        cross   da0, da1, da2, db0, db1, db2, c20, c21, c22, e12
        .endm

; Computes N in e0-e2, N . o in e3.
        .macro  towards_triple t, o, n
        LINKV
        MPYSV   [\o], triple_w, [\n]
        SUBNV   \t, [\n], [\n]
        .endm

        .macro  plane_of_ray
        towards_triple triple_x, lane_ox, e0
        towards_triple triple_y, lane_oy, e1
        towards_triple triple_z, lane_oz, e2
        dot_vectors e0, e1, e2, lane_dx, lane_dy, lane_dz, e3, e12
        MPYSV   [e3], [lane_dx], [e12]
        SUBNV   [e0], [e12], [e0]
        MPYSV   [e3], [lane_dy], [e12]
        SUBNV   [e1], [e12], [e1]
        MPYSV   [e3], [lane_dz], [e12]
        SUBNV   [e2], [e12], [e2]
        dot_vectors e0, e1, e2, lane_ox, lane_oy, lane_oz, e3, e12
        .endm

        .macro  plane_form qx, qy, qz, qw, f
        dot_constant e0, e1, e2, \qx, \qy, \qz, \f, e12
        LINKV
        MPYSV   [e3], \qw, [e12]
        SUBNV   [\f], [e12], [\f]
        .endm

; Computes v in e4-e6 := A c.
        .macro  form_times c0, c1, c2
        dot_vectors fss, fst, fus, \c0, \c1, \c2, e4, e12
        dot_vectors fst, ftt, ftu, \c0, \c1, \c2, e5, e12
        dot_vectors fus, ftu, fuu, \c0, \c1, \c2, e6, e12
        .endm

        .macro  implicit_quartic
        plane_form qxss, qyss, qzss, qwss, fss
        plane_form qxtt, qytt, qztt, qwtt, ftt
        plane_form qxuu, qyuu, qzuu, qwuu, fuu
        plane_form qxst, qyst, qzst, qwst, fst
        plane_form qxtu, qytu, qztu, qwtu, ftu
        plane_form qxus, qyus, qzus, qwus, fus
        form_times c00, c01, c02
        dot_vectors c00, c01, c02, e4, e5, e6, k0, e12
        dot_vectors c10, c11, c12, e4, e5, e6, k1, e12
        dot_vectors c20, c21, c22, e4, e5, e6, k2, e12
        ADDNV   [k1], [k1], [k1]
        ADDNV   [k2], [k2], [k2]
        form_times c10, c11, c12
        dot_vectors c10, c11, c12, e4, e5, e6, e7, e12
        ADDNV   [k2], [e7], [k2]
        dot_vectors c20, c21, c22, e4, e5, e6, k3, e12
        ADDNV   [k3], [k3], [k3]
        form_times c20, c21, c22
        dot_vectors c20, c21, c22, e4, e5, e6, k4, e12
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

        .kernel steiner
rational_steiner_implicit:
        EX      other_kernel, rational_steiner
        BIM     implicit_begin
steiner_implicit:
        EX      other_kernel, steiner
implicit_begin:
        load_record P_SHAPE, 6, sh0
        SUBNV   [ox], sh0, [w8]
        SUBNV   [oy], sh1, [w9]
        SUBNV   [oz], sh2, [w10]
        find_lanes w8, w9, w10, sh3, implicit_miss
        take_lanes
        set_more_lanes m
        EX      s2, implicit_numbers + 64 * 2
        LOD     [s2], s2
        MPYS    sh3, s2, s2
        load_field P_TABLE, shape_at
        IX      shape_at, 64 * PATCH_TABLE
        ELEN    shape_at, PLANES_TABLE
        SWAP    [shape_at], la00, [r0]
        parameters_of_ray
        plane_of_ray
        dot_vectors e0, e1, e2, e0, e1, e2, e4, e12
        CMPGEV  s2, [e4], [hits0]
        CNTOB   [hits0], through_count
        IBXEQ   through_count, r0, r0, implicit_form
        VTOV    [lane_low], [lane_high] ? [hits0]       ; no interval: no root
implicit_form:
        IX      shape_at, 64 * PLANES_TABLE
        ELEN    shape_at, FORMS_TABLE
        SWAP    [shape_at], qxss, [r0]
        implicit_quartic
        load_record P_SHAPE + 6, 1, s9          ; resolution
        EX      s8, implicit_accept
        solve_lanes s9, solve_quartic_until
        VTOVX   [lane_at], [found_s], [patch_s] ? [hits0]
        VTOVX   [lane_at], [found_t], [patch_t] ? [hits0]
        IBXNE   through_count, r0, r0, implicit_through
        BIM     0, link_kernel
implicit_miss:
        miss_all

; The other kernel processes the whole queue.  Then all rays except those
; through T get their previous results back.
implicit_through:
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

; Accepts the roots whose parameters are in the triangle.
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
        EX      s2, implicit_numbers
        ELEN    s2, 2
        SWAP    [s2], s3, [r0]
        CMPGEV  [q_a], s3, [q_bits]
        CMPGEV  [q_b], s3, [q_change]
        ANDB    [q_bits], [q_change], [q_bits]
        ADDNV   [q_a], [q_b], [q_s]
        CMPGEV  s4, [q_s], [q_change]
        ANDB    [q_bits], [q_change], [q_bits]
        VTOVX   [q_at], [q_a], [found_s] ? [q_bits]
        VTOVX   [q_at], [q_b], [found_t] ? [q_bits]
        BIM     0, s9
        .endkernel
