; steiner_patch_scalar.s - the scalar form of the Steiner patch.

        .share  local
        .regs   r86, pa0, pa1, pa2, pa3, pa4, pa5, pb0, pb1, pb2, pb3, pb4
        .regs   r97, n1x, n1y, n1z, n2x, n2y, n2z
        .regs   r103, spread, patch_low, patch_high, patch_least
        .regs   r107, patch_link, candidate_routine, roots_left, root_at
        .regs   r111, candidate_s, candidate_t, patch_s, patch_t
        .regs   r115, quarter, sixth, noise, last_step
        .regs   r119, kx0, ky0, kz0, kx1, ky1, kz1, kx2, ky2, kz2, kx3, ky3
        .regs   r130, kz3, kx4, ky4, kz4, kx5, ky5, kz5
        .regs   r137, kw0, kw1, kw2, kw3, kw4, kw5
        .regs   r143, other_x, other_y, other_z
        .regs   r146, g0, g1, g2, g3
        .regs   r83, crossings_wanted, crossings_left, point_at
        .endshare
        .regs   t3, temp0, temp1, temp2, temp3, temp4, temp5, temp6
        .regs   sh4, parallel_limit, spread_limit
        .reg    patch_half, m_half
        .reg    root_s, candidate_s
        .equ    PATCH_REGISTERS, 118

        .data
patch_save:     .space PATCH_REGISTERS
        .code

        .macro  load_patch
        load_of a_primitive, P_TABLE, t3
        load_from t3, PATCH_TABLE, kx0
        load_words patch_numbers, 4, quarter, t3
        .endm

        .macro  other_plane
        CFPLT   e3, spread, planes_found\@
        cross_product dx, dy, dz, other_x, other_y, other_z, n2x, n2y, n2z
        dot     n2x, n2y, n2z, n2x, n2y, n2z, spread, t3
planes_found\@:
        .endm

        .macro  lower_conic c, no, count
        .rept   \count
        MPYS    \no, kw\+, temp\+
        .endr
        .rept   \count
        SUBN    \c\+, temp\+, \c\+
        .endr
        .endm

        .macro  to_double a, b, c
        MPYS    \a, \b, \c
        .endm

        .macro  doubled c
        ADDN    \c, \c, \c
        .endm

        .macro  bernstein_signs miss
        ABS     k0, t3
        ABS     k1, t4
        ABS     k2, t5
        ABS     k3, t6
        ABS     k4, t7
        ADDN    t3, t4, t8
        MPYS    k1, quarter, t3
        MPYS    k2, sixth, t4
        ADDN    t5, t8, t8
        MPYS    k3, quarter, t5
        ADDN    k0, k1, e3
        ADDN    t6, t8, t8
        ADDN    k0, t3, e0
        ADDN    t3, t4, t6
        ADDN    e3, k2, e3
        ADDN    t7, t8, t8
        ADDN    e0, t6, e1
        ADDN    t6, t4, t6
        ADDN    e3, k3, e3
        MPYS    t8, noise, t8
        ADDN    t6, t5, t6
        ADDN    e3, k4, e3
        SUBN    r0, t8, t9
        ADDN    e1, t6, e2
        CFPLT   t8, k0, bernstein_above\@
        CFPGE   k0, t9, bernstein_end\@
        CFPGE   e0, t9, bernstein_end\@
        CFPGE   e1, t9, bernstein_end\@
        CFPGE   e2, t9, bernstein_end\@
        CFPLT   e3, t9, \miss
        BIM     bernstein_end\@
bernstein_above\@:
        CFPGE   t8, e0, bernstein_end\@
        CFPGE   t8, e1, bernstein_end\@
        CFPGE   t8, e2, bernstein_end\@
        CFPLT   t8, e3, \miss
bernstein_end\@:
        .endm

        .macro  patch_coordinate k0, k1, k2, k3, k4, k5, sum
        MPYS    candidate_s, \k1, \sum
        MPYS    candidate_t, \k2, t3
        MPYS    e4, \k3, t4
        MPYS    e5, \k4, t5
        ADDN    \sum, \k0, \sum
        MPYS    e6, \k5, t6
        ADDN    t3, \sum, \sum
        ADDN    t4, \sum, \sum
        ADDN    t5, \sum, \sum
        ADDN    t6, \sum, \sum
        .endm

        .macro  keep_in_triangle none
        CFPLT   candidate_t, patch_low, \none
        ADDN    candidate_s, candidate_t, e3
        MPYS    candidate_s, candidate_s, e4
        CFPLT   patch_high, e3, \none
        MPYS    candidate_s, candidate_t, e5
        MPYS    candidate_t, candidate_t, e6
        .endm

        .macro  keep_ahead none
        CFPGE   patch_least, e3, \none
        .endm

; Keeps the nearest candidate.
        .macro  patch_candidate rational
        patch_distance \rational, candidate_none\@
        CFPGE   e3, tin, candidate_none\@
        RTOR    e3, tin
        RTOR    candidate_s, patch_s
        RTOR    candidate_t, patch_t
candidate_none\@:
        BIM     0, patch_link
        .endm

; Stores every candidate while there is room.
        .macro  patch_crossing rational
        patch_distance \rational, crossing_none\@
        IBXEQ   crossings_left, r0, r0, crossing_none\@
        IX      crossings_left, -1
        STO     [a_segment], e3
        STO     [point_at], candidate_s
        STO     [point_at, index_one], candidate_t
        IX      a_segment, 64
        IX      point_at, 64 * 2
crossing_none\@:
        BIM     0, patch_link
        .endm

; Crossings are set to big.
        .macro  enter_patch routine, wanted
        enter_solver 6, patch_save, PATCH_REGISTERS
        EX      candidate_routine, \routine
        ES      crossings_wanted, \wanted
        .if     \wanted
        RTOR    a_segment, point_at
        .rept   \wanted
        STO     [point_at], big
        IX      point_at, 64
        .endr
        address_of a_primitive, P_PATCH_POINTS, point_at
        RTOR    crossings_wanted, crossings_left
        .endif
        .endm

        .macro  solve_patch
        RTOR    near_low, patch_least
        load_words patch_limits, 3, near_low, t3
        RTOR    near_low, patch_low
        RTOR    near_high, patch_high
        call_quartic solve_quartic_all
        EX      root_at, near_roots
        IX      root_at, 64 * 4
        LOD     [root_at], roots_left
        EX      root_at, near_roots
        RTOR    big, tin
        .endm

        .macro  begin_root done
        CFPGE   r0, roots_left, \done
        LOD     [root_at], candidate_s
        IX      root_at, 64
        SUBN    roots_left, one, roots_left
        .endm

        .macro  test_root lines
        CFPLT   spread, temp0, root_plain\@
        CFPGE   spread, temp1, \lines
root_plain\@:
        SUBN    r0, e0, e0
        DIVS    e0, e1, candidate_t
        BSAVE   patch_link, [candidate_routine]
        .endm

        no_code next_root

        .macro  leave_patch done, miss
\done:
        CFPGE   tin, big, \miss
        RTOR    tin, tout
        IX      a_primitive, 64 * P_PATCH_POINT
        STO     [a_primitive], patch_s
        STO     [a_primitive, index_one], patch_t
        leave_solver patch_save, PATCH_REGISTERS
\miss:
        IBXNE   crossings_wanted, r0, r0, patch_stored\@
        miss_near patch_save, PATCH_REGISTERS
patch_stored\@:
        leave_segments patch_save, PATCH_REGISTERS
        .endm

        .macro  first_candidate
        SQRT    temp0, temp1
        ABS     e1, g0
        ADDN    g0, temp1, temp1
        CFPLT   e1, r0, candidate_signed\@
        SUBN    r0, temp1, temp1
candidate_signed\@:
        DIVS    e0, temp1, g1
        DIVS    temp1, pa5, candidate_t
        RTOR    candidate_s, g2
        .endm

        .macro  second_candidate
        RTOR    g2, candidate_s
        RTOR    g1, candidate_t
        .endm

        .macro  leave_newton
        ABS     e0, e0
        ABS     e1, e1
        ADDN    e0, e1, e0
        CFPLT   e0, last_step, newton_settled\@
newton_lost\@:
        BIM     0, patch_link
newton_settled\@:
        CFPLT   candidate_s, patch_low, newton_lost\@
        BIM     0, candidate_routine
        .endm
