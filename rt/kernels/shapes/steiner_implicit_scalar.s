; steiner_implicit_scalar.s - intersects one ray with a Steiner patch by the
; quartic of its surface.
;
;       CALL STEINER_IMPLICIT (RAY, PRIMITIVE, SEGMENT)
;       CALL RATIONAL_STEINER_IMPLICIT (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; steiner_implicit_vector.s.  P_PATCH_POINT is written as in
; steiner_patch_scalar.s.  The solver stops at the first root that is accepted.

        .share  local
        .regs   r87, ma0, ma1, ma2, da0, da1, da2, mb0, mb1, mb2, db0, db1, db2
        .regs   r99, c00, c01, c02, c10, c11, c12, c20, c21, c22
        .regs   r108, nx, ny, nz, no
        .regs   r113, patch_s, patch_t
        .regs   r116, la00, la01, la02, la03, la10, la11, la12, la13
        .regs   r124, la20, la21, la22, la23
        .regs   r128, lb00, lb01, lb02, lb03, lb10, lb11, lb12, lb13
        .regs   r136, lb20, lb21, lb22, lb23
        .regs   r140, triple_x, triple_y, triple_z, triple_w
        .endshare
        .equ    PLANES_TABLE, 28
        .share  local                   ; the registers are used again
        .regs   r116, qxss, qxtt, qxuu, qxst, qxtu, qxus
        .regs   r122, qyss, qytt, qyuu, qyst, qytu, qyus
        .regs   r128, qzss, qztt, qzuu, qzst, qztu, qzus
        .regs   r134, qwss, qwtt, qwuu, qwst, qwtu, qwus
        .equ    FORMS_TABLE, 24
        .regs   r87, fss, ftt, fuu, fst, ftu, fus
        .regs   r145, margin_low, margin_high, through
        .regs   r144, table_at
        .endshare

        .macro  plane_rows la00, la01, la02, la03, la10, la11, la12, la13, la20, la21, la22, la23, a0, a1, a2, d0, d1, d2
        dot_rows t0, t1, t2, \la00, \la01, \la02, \la10, \la11, \la12, \la20, \la21, \la22, \a0, \a1, \a2, t3, t4, t5, t6
        dot_rows dx, dy, dz, \la00, \la01, \la02, \la10, \la11, \la12, \la20, \la21, \la22, \d0, \d1, \d2, t3, t4, t5, t6
        ADDN    \a0, \la03, \a0
        ADDN    \a1, \la13, \a1
        ADDN    \a2, \la23, \a2
        .endm

        .macro  plane_of_ray
        MPYS    t0, triple_w, nx
        MPYS    t1, triple_w, ny
        MPYS    t2, triple_w, nz
        SUBN    triple_x, nx, nx
        SUBN    triple_y, ny, ny
        SUBN    triple_z, nz, nz
        dot     nx, ny, nz, dx, dy, dz, no, t3
        MPYS    no, dx, t3
        MPYS    no, dy, t4
        MPYS    no, dz, t5
        SUBN    nx, t3, nx
        SUBN    ny, t4, ny
        SUBN    nz, t5, nz
        dot     nx, ny, nz, t0, t1, t2, no, t3
        .endm

; Computes three entries of A.
        .macro  plane_forms x0, y0, z0, w0, x1, y1, z1, w1, x2, y2, z2, w2, f0, f1, f2
        dot_rows nx, ny, nz, \x0, \y0, \z0, \x1, \y1, \z1, \x2, \y2, \z2, \f0, \f1, \f2, t3, t4, t5, t6
        MPYS    no, \w0, t3
        MPYS    no, \w1, t4
        MPYS    no, \w2, t5
        SUBN    \f0, t3, \f0
        SUBN    \f1, t4, \f1
        SUBN    \f2, t5, \f2
        .endm

; Computes v in t7-t9 := A c.
        .macro  form_times c0, c1, c2
        MPYS    fss, \c0, t7
        MPYS    fst, \c0, t8
        MPYS    fus, \c0, t9
        MPYS    fst, \c1, t3
        MPYS    ftt, \c1, t4
        MPYS    ftu, \c1, t5
        MPYS    fus, \c2, t6
        MPYS    ftu, \c2, third
        MPYS    fuu, \c2, fourth
        ADDN    t3, t7, t7
        ADDN    t4, t8, t8
        ADDN    t5, t9, t9
        ADDN    t6, t7, t7
        ADDN    third, t8, t8
        ADDN    fourth, t9, t9
        .endm

        .kernel steiner
rational_steiner_implicit:
        EX      target, rational_steiner
        BIM     implicit_begin
steiner_implicit:
        EX      target, steiner
implicit_begin:
        enter_solver 7, patch_save, PATCH_REGISTERS
        SUBN    ox, sh0, t5
        SUBN    oy, sh1, t6
        SUBN    oz, sh2, t7
        find_lanes t5, t6, t7, sh3, implicit_miss
        RTOR    sh6, near_resolution
        RTOR    a_primitive, table_at
        IX      table_at, 64 * P_TABLE
        LOD     [table_at], table_at
        IX      table_at, 64 * PATCH_TABLE
        ELEN    table_at, PLANES_TABLE
        SWAP    [table_at], la00, [r0]
        plane_rows la00, la01, la02, la03, la10, la11, la12, la13, la20, la21, la22, la23, ma0, ma1, ma2, da0, da1, da2
        plane_rows lb00, lb01, lb02, lb03, lb10, lb11, lb12, lb13, lb20, lb21, lb22, lb23, mb0, mb1, mb2, db0, db1, db2
        cross_product ma0, ma1, ma2, mb0, mb1, mb2, c00, c01, c02
        cross_product ma0, ma1, ma2, db0, db1, db2, c10, c11, c12
        cross_product da0, da1, da2, mb0, mb1, mb2, e0, e1, e2
        cross_product da0, da1, da2, db0, db1, db2, c20, c21, c22
        ADDN    c10, e0, c10
        ADDN    c11, e1, c11
        ADDN    c12, e2, c12
        EX      t3, implicit_numbers
        ELEN    t3, 3
        SWAP    [t3], margin_low, [r0]
        plane_of_ray
        dot     nx, ny, nz, nx, ny, nz, e0, t3
        MPYS    sh3, through, e1
        IX      table_at, 64 * PLANES_TABLE
        ELEN    table_at, FORMS_TABLE
        SWAP    [table_at], qxss, [r0]
        CFPGE   e1, e0, implicit_through
        plane_forms qxss, qyss, qzss, qwss, qxtt, qytt, qztt, qwtt, qxuu, qyuu, qzuu, qwuu, fss, ftt, fuu
        plane_forms qxst, qyst, qzst, qwst, qxtu, qytu, qztu, qwtu, qxus, qyus, qzus, qwus, fst, ftu, fus
        form_times c00, c01, c02
        dot_rows t7, t8, t9, c00, c01, c02, c10, c11, c12, c20, c21, c22, k0, k1, k2, t3, t4, t5, t6
        ADDN    k1, k1, k1
        ADDN    k2, k2, k2
        form_times c10, c11, c12
        dot     t7, t8, t9, c10, c11, c12, e0, t3
        dot     t7, t8, t9, c20, c21, c22, k3, t4
        ADDN    k2, e0, k2
        ADDN    k3, k3, k3
        form_times c20, c21, c22
        dot     t7, t8, t9, c20, c21, c22, k4, t3
        EX      t3, near_input
        ELEN    t3, 8
        SWAP    [r0], k4, [t3]
        EX      fourth, implicit_accept
        call    solve_quartic_until, near_list
        EX      t3, near_roots
        LOD     [t3], tin
        CFPGE   tin, big, implicit_miss
        SUBN    tin, along, tin
        BIM     steiner_done
implicit_miss:
        miss_near patch_save, PATCH_REGISTERS

; A ray through the triple point: the other kernel continues with its arguments.
implicit_through:
        RTOR    link_kept, link
        EX      save_at, patch_save
        ELEN    save_at, PATCH_REGISTERS
        SWAP    [save_at], r32, [r0]
        BIM     0, target

; Accepts a root if its parameters are in the triangle.
implicit_accept:
        MPYS    c20, q_answer, q_a
        MPYS    c21, q_answer, q_b
        MPYS    c22, q_answer, q_x
        ADDN    q_a, c10, q_a
        ADDN    q_b, c11, q_b
        ADDN    q_x, c12, q_x
        MPYS    q_a, q_answer, q_a
        MPYS    q_b, q_answer, q_b
        MPYS    q_x, q_answer, q_x
        ADDN    q_a, c00, q_a
        ADDN    q_b, c01, q_b
        ADDN    q_x, c02, q_x
        ADDN    q_a, q_b, q_s
        ADDN    q_s, q_x, q_s
        DIVS    q_a, q_s, patch_s
        DIVS    q_b, q_s, patch_t
        CFPLT   patch_s, margin_low, implicit_refuse
        CFPLT   patch_t, margin_low, implicit_refuse
        ADDN    patch_s, patch_t, q_s
        CFPGE   margin_high, q_s, solver_accept
implicit_refuse:
        BIM     0, q_link
        .endkernel
