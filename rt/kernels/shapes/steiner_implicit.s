; steiner_implicit.s - intersects rays with a Steiner patch by the quartic of
; the surface that contains it: the method of 1984, for comparison.
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
; Such rays are intersected by steiner_patch.s.
;
; steiner_implicit, rational_steiner_implicit: the entries select the kernel for
; such rays, steiner or rational_steiner.
;
;       CALL STEINER_IMPLICIT (RAY, PRIMITIVE, SEGMENT)
;       CALL RATIONAL_STEINER_IMPLICIT (RAY, PRIMITIVE, SEGMENT)
;
; In:  ox oy oz dx dy dz lower, n long; the primitive's record and the part
;      of its table after PATCH_TABLE.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big;
;      patch_s, patch_t where there is a crossing.
; Source: the project's notes on ray tracing, 2.2 (B), which derive it; the
; paper says only that the quartic is solved.

; The rest of the table is in two parts: L1, L2 by rows, T; then the forms
; Qx Qy Qz Qw, each as ss tt uu st tu us.
        .equ    PLANES_TABLE, 28
        .equ    FORMS_TABLE, 24
        include_form steiner_implicit

        .macro  plane_rows la00, la01, la02, la03, la10, la11, la12, la13, la20, la21, la22, la23, a0, a1, a2, d0, d1, d2
        dot_constants near_ox, near_oy, near_oz, \la00, \la01, \la02, \la10, \la11, \la12, \la20, \la21, \la22, \a0, \a1, \a2, temp0, temp1, temp2, temp3
        dot_constants near_dx, near_dy, near_dz, \la00, \la01, \la02, \la10, \la11, \la12, \la20, \la21, \la22, \d0, \d1, \d2, temp0, temp1, temp2, temp3
        three   ray_raise, \a0, \a1, \a2, \la03, \la13, \la23, \a0, \a1, \a2
        .endm

        .macro  parameters_of_ray
        plane_rows la00, la01, la02, la03, la10, la11, la12, la13, la20, la21, la22, la23, ma0, ma1, ma2, da0, da1, da2
        plane_rows lb00, lb01, lb02, lb03, lb10, lb11, lb12, lb13, lb20, lb21, lb22, lb23, mb0, mb1, mb2, db0, db1, db2
        cross_vectors ma0, ma1, ma2, mb0, mb1, mb2, c00, c01, c02, temp0
        cross_vectors ma0, ma1, ma2, db0, db1, db2, c10, c11, c12, temp0
        cross_vectors da0, da1, da2, mb0, mb1, mb2, e0, e1, e2, temp0
        cross_vectors da0, da1, da2, db0, db1, db2, c20, c21, c22, temp0
        three   ray_plus, c10, c11, c12, e0, e1, e2, c10, c11, c12
        .endm

; Computes N in plane_x, plane_y, plane_z and N . o in plane_o.
        .macro  plane_of_ray
        from_scaled_three triple_w, triple_x, near_ox, plane_x, triple_y, near_oy, plane_y, triple_z, near_oz, plane_z
        make_perpendicular plane_x, plane_y, plane_z
        dot_vectors plane_x, plane_y, plane_z, near_ox, near_oy, near_oz, plane_o, temp0
        .endm

; Computes three entries of A.
        .macro  plane_forms x0, y0, z0, w0, x1, y1, z1, w1, x2, y2, z2, w2, f0, f1, f2
        dot_constants plane_x, plane_y, plane_z, \x0, \y0, \z0, \x1, \y1, \z1, \x2, \y2, \z2, \f0, \f1, \f2, temp0, temp1, temp2, temp3
        minus_scaled_three plane_o, \f0, \w0, \f1, \w1, \f2, \w2
        .endm

; Computes v := A c.
        .macro  form_times c0, c1, c2
        dot_rows_of \c0, \c1, \c2, fss, fst, fus, fst, ftt, ftu, fus, ftu, fuu, form0, form1, form2
        .endm

        .macro  implicit_quartic
        plane_forms qxss, qyss, qzss, qwss, qxtt, qytt, qztt, qwtt, qxuu, qyuu, qzuu, qwuu, fss, ftt, fuu
        plane_forms qxst, qyst, qzst, qwst, qxtu, qytu, qztu, qwtu, qxus, qyus, qzus, qwus, fst, ftu, fus
        form_times c00, c01, c02
        dot_rows_of form0, form1, form2, c00, c01, c02, c10, c11, c12, c20, c21, c22, k0, k1, k2
        ray_plus k1, k1, k1
        ray_plus k2, k2, k2
        form_times c10, c11, c12
        dot_vectors form0, form1, form2, c10, c11, c12, e0, temp0
        dot_vectors form0, form1, form2, c20, c21, c22, k3, temp1
        ray_plus k2, e0, k2
        ray_plus k3, k3, k3
        form_times c20, c21, c22
        dot_vectors form0, form1, form2, c20, c21, c22, k4, temp0
        .endm

        .kernel steiner
rational_steiner_implicit:
        EX      other_kernel, rational_steiner
        BIM     implicit_begin
steiner_implicit:
        EX      other_kernel, steiner
implicit_begin:
        enter_implicit
        three   ray_lower, ox, oy, oz, sh0, sh1, sh2, t5, t6, t7
        find_lanes t5, t6, t7, sh3, implicit_miss
        take_lanes
        load_planes
        parameters_of_ray
        load_margins
        plane_of_ray
        dot_vectors plane_x, plane_y, plane_z, plane_x, plane_y, plane_z, form0, temp0
        leave_through implicit_through
        implicit_quartic
        leave_implicit implicit_through, implicit_miss
        accept_implicit
        .endkernel
