; steiner_implicit_scalar.s - the scalar form of the implicit Steiner patch.
; The solver stops at the first root that is accepted.

        .share  local
        .regs   r87, ma0, ma1, ma2, da0, da1, da2, mb0, mb1, mb2, db0, db1, db2
        .regs   r99, c00, c01, c02, c10, c11, c12, c20, c21, c22
        .regs   r108, plane_x, plane_y, plane_z, plane_o
        .regs   r113, patch_s, patch_t
        .regs   r116, la00, la01, la02, la03, la10, la11, la12, la13
        .regs   r124, la20, la21, la22, la23
        .regs   r128, lb00, lb01, lb02, lb03, lb10, lb11, lb12, lb13
        .regs   r136, lb20, lb21, lb22, lb23
        .regs   r140, triple_x, triple_y, triple_z, triple_w
        .endshare
        .share  local                   ; the registers are used again
        .regs   r116, qxss, qxtt, qxuu, qxst, qxtu, qxus
        .regs   r122, qyss, qytt, qyuu, qyst, qytu, qyus
        .regs   r128, qzss, qztt, qzuu, qzst, qztu, qzus
        .regs   r134, qwss, qwtt, qwuu, qwst, qwtu, qwus
        .regs   r87, fss, ftt, fuu, fst, ftu, fus
        .regs   r145, margin_low, margin_high, through
        .regs   r144, table_at
        .endshare
        .regs   t7, form0, form1, form2
        .reg    other_kernel, target

        .macro  minus_scaled_three a, f0, k0, f1, k1, f2, k2
        three_by MPYS, \a, \k0, \k1, \k2, t3, t4, t5
        three   SUBN, \f0, \f1, \f2, t3, t4, t5, \f0, \f1, \f2
        .endm

        .macro  dot_rows_of x0, x1, x2, a0, a1, a2, b0, b1, b2, c0, c1, c2, a, b, c
        dot_rows \x0, \x1, \x2, \a0, \a1, \a2, \b0, \b1, \b2, \c0, \c1, \c2, \a, \b, \c, t3, t4, t5, t6
        .endm

        .macro  enter_implicit
        enter_solver 7, patch_save, PATCH_REGISTERS
        .endm

        .macro  load_planes
        RTOR    sh6, near_resolution
        load_of a_primitive, P_TABLE, table_at
        IX      table_at, 64 * PATCH_TABLE
        load_from table_at, PLANES_TABLE, la00
        .endm

        .macro  load_margins
        load_words implicit_numbers, 3, margin_low, t3
        .endm

        .macro  leave_through label
        MPYS    sh3, through, e1
        IX      table_at, 64 * PLANES_TABLE
        load_from table_at, FORMS_TABLE, qxss
        CFPGE   e1, form0, \label
        .endm

; For a ray through the triple point the other kernel continues with the
; arguments of this one.
        .macro  leave_implicit through, miss
        store_words k4, 8, near_input, t3
        EX      fourth, implicit_accept
        call    solve_quartic_until, near_list
        EX      t3, near_roots
        LOD     [t3], tin
        CFPGE   tin, big, \miss
        SUBN    tin, along, tin
        BIM     steiner_done
\miss:
        miss_near patch_save, PATCH_REGISTERS
\through:
        RTOR    link_kept, link
        load_words patch_save, PATCH_REGISTERS, r32, save_at
        BIM     0, target
        .endm

; Accepts a root if its parameters are in the triangle.
        .macro  accept_implicit
implicit_accept:
        three_by MPYS, q_answer, c20, c21, c22, q_a, q_b, q_x
        three   ADDN, q_a, q_b, q_x, c10, c11, c12, q_a, q_b, q_x
        three_by MPYS, q_answer, q_a, q_b, q_x, q_a, q_b, q_x
        three   ADDN, q_a, q_b, q_x, c00, c01, c02, q_a, q_b, q_x
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
        .endm
