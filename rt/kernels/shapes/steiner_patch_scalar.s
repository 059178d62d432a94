; steiner_patch_scalar.s - intersects one ray with a Steiner patch.
;
;       CALL STEINER (RAY, PRIMITIVE, SEGMENT)
;       CALL RATIONAL_STEINER (RAY, PRIMITIVE, SEGMENT)
;       CALL STEINER_CROSSINGS (RAY, PRIMITIVE, CROSSINGS)
;       CALL RATIONAL_STEINER_CROSSINGS (RAY, PRIMITIVE, CROSSINGS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; steiner_patch_vector.s.  The parameters of the hit are stored in
; P_PATCH_POINT.  CROSSINGS receives all crossings, unsorted, then big
; (PATCH_CROSSINGS words); their parameters are stored in P_PATCH_POINTS.

        .ifndef LANE_REGISTERS
        .include "shapes/lanes_scalar.s"
        .endif
        .include "shapes/steiner_constants.s"

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
        .equ    PATCH_TABLE, 27
        .equ    PATCH_REGISTERS, 118

        .data
patch_save:     .space PATCH_REGISTERS
        .code

        .macro  conics rational
        dot     n1x, n1y, n1z, t0, t1, t2, e0, t3
        dot     n2x, n2y, n2z, t0, t1, t2, e1, t3
        dot_rows n1x, n1y, n1z, kx0, ky0, kz0, kx1, ky1, kz1, kx2, ky2, kz2, pa0, pa1, pa2, t3, t4, t5, t6
        dot_rows n1x, n1y, n1z, kx3, ky3, kz3, kx4, ky4, kz4, kx5, ky5, kz5, pa3, pa4, pa5, t3, t4, t5, t6
        dot_rows n2x, n2y, n2z, kx0, ky0, kz0, kx1, ky1, kz1, kx2, ky2, kz2, pb0, pb1, pb2, t3, t4, t5, t6
        dot     n2x, n2y, n2z, kx3, ky3, kz3, pb3, t3
        dot     n2x, n2y, n2z, kx4, ky4, kz4, pb4, t3
        .if     \rational
        MPYS    e0, kw0, t3
        MPYS    e0, kw1, t4
        MPYS    e0, kw2, t5
        MPYS    e0, kw3, t6
        MPYS    e0, kw4, t7
        MPYS    e0, kw5, t8
        SUBN    pa0, t3, pa0
        SUBN    pa1, t4, pa1
        SUBN    pa2, t5, pa2
        SUBN    pa3, t6, pa3
        SUBN    pa4, t7, pa4
        SUBN    pa5, t8, pa5
        MPYS    e1, kw0, t3
        MPYS    e1, kw1, t4
        MPYS    e1, kw2, t5
        MPYS    e1, kw3, t6
        MPYS    e1, kw4, t7
        SUBN    pb0, t3, pb0
        SUBN    pb1, t4, pb1
        SUBN    pb2, t5, pb2
        SUBN    pb3, t6, pb3
        SUBN    pb4, t7, pb4
        .else
        SUBN    pa0, e0, pa0
        SUBN    pb0, e1, pb0
        .endif
        .endm

        .macro  planes rational
        .if     \rational
        MPYS    t0, kw5, e0
        MPYS    t1, kw5, e1
        MPYS    t2, kw5, e2
        SUBN    kx5, e0, e0
        SUBN    ky5, e1, e1
        SUBN    kz5, e2, e2
        cross_product dx, dy, dz, e0, e1, e2, n2x, n2y, n2z
        dot     e0, e1, e2, e0, e1, e2, e3, t3
        MPYS    e3, sh4, e3
        .else
        cross_product dx, dy, dz, kx5, ky5, kz5, n2x, n2y, n2z
        RTOR    sh4, e3
        .endif
        dot     n2x, n2y, n2z, n2x, n2y, n2z, spread, t3
        CFPLT   e3, spread, planes_found\@
        cross_product dx, dy, dz, other_x, other_y, other_z, n2x, n2y, n2z
        dot     n2x, n2y, n2z, n2x, n2y, n2z, spread, t3
planes_found\@:
        MPYS    spread, sh5, spread
        dot     n2x, n2y, n2z, dx, dy, dz, e0, t3
        MPYS    e0, dx, t3
        MPYS    e0, dy, t4
        MPYS    e0, dz, t5
        SUBN    n2x, t3, n2x
        SUBN    n2y, t4, n2y
        SUBN    n2z, t5, n2z
        cross_product n2x, n2y, n2z, dx, dy, dz, n1x, n1y, n1z
        .endm

; Computes k4 .. k0 = R, with G in g0-g3 and B0(s)^2 in e0-e4.
        .macro  eliminate
        MPYS    pa0, pb2, g0
        MPYS    pa2, pb0, t3
        MPYS    pa0, pb4, g1
        MPYS    pa1, pb2, t4
        MPYS    pa1, pb4, g2
        MPYS    pa3, pb2, t5
        MPYS    pa3, pb4, g3
        MPYS    pa4, pb3, t6
        SUBN    g0, t3, g0
        MPYS    pa2, pb1, t3
        ADDN    g1, t4, g1
        MPYS    pa4, pb0, t4
        ADDN    g2, t5, g2
        MPYS    pa2, pb3, t5
        SUBN    g3, t6, g3
        MPYS    pa4, pb1, t6
        SUBN    g1, t3, g1
        MPYS    pb0, pb0, e0
        MPYS    pb0, pb1, e1
        SUBN    g2, t5, g2
        MPYS    pb0, pb3, e2
        SUBN    g1, t4, g1
        MPYS    pb1, pb1, t3
        MPYS    pb1, pb3, e3
        SUBN    g2, t6, g2
        ADDN    e1, e1, e1
        MPYS    pb3, pb3, e4
        ADDN    e2, e2, e2
        MPYS    pa5, e0, k0
        MPYS    pb2, g0, t4
        ADDN    e3, e3, e3
        MPYS    pa5, e1, k1
        MPYS    pb2, g1, t5
        ADDN    e2, t3, e2
        MPYS    pb4, g0, t6
        MPYS    pa5, e4, k4
        ADDN    k0, t4, k0
        MPYS    pb4, g3, t7
        ADDN    k1, t5, k1
        MPYS    pa5, e2, k2
        MPYS    pb2, g2, t8
        MPYS    pa5, e3, k3
        MPYS    pb2, g3, t9
        ADDN    k4, t7, k4
        ADDN    k1, t6, k1
        MPYS    pb4, g1, t3
        ADDN    k2, t8, k2
        MPYS    pb4, g2, t4
        ADDN    k3, t9, k3
        ADDN    k2, t3, k2
        ADDN    k3, t4, k3
        .endm

; Branches to miss if the Bernstein coefficients of R (k0, e0-e3) have one sign.
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

; e3 := the distance of the point candidate_s, candidate_t along the ray.
; Branches to none if the point is not on the patch or not ahead.
        .macro  patch_distance rational, none
        CFPLT   candidate_t, patch_low, \none
        ADDN    candidate_s, candidate_t, e3
        MPYS    candidate_s, candidate_s, e4
        CFPLT   patch_high, e3, \none
        MPYS    candidate_s, candidate_t, e5
        MPYS    candidate_t, candidate_t, e6
        patch_coordinate kx0, kx1, kx2, kx3, kx4, kx5, t7
        patch_coordinate ky0, ky1, ky2, ky3, ky4, ky5, t8
        patch_coordinate kz0, kz1, kz2, kz3, kz4, kz5, t9
        dot     dx, dy, dz, t7, t8, t9, e3, t3
        .if     \rational
        patch_coordinate kw0, kw1, kw2, kw3, kw4, kw5, t7
        DIVS    e3, t7, e3
        .endif
        CFPGE   patch_least, e3, \none
        SUBN    e3, along, e3
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

        .macro  newton_step
        MPYS    pa3, candidate_s, e0
        MPYS    pa4, candidate_t, e1
        MPYS    pa5, candidate_t, t3
        MPYS    pa4, candidate_s, t4
        MPYS    pb3, candidate_s, t5
        MPYS    pb4, candidate_t, t6
        ADDN    pa1, e0, e2
        ADDN    pa2, t3, e4
        MPYS    pb4, candidate_s, t8
        ADDN    pb1, t5, e6
        ADDN    e2, e1, e2
        ADDN    e4, t3, e5
        ADDN    e6, t6, e6
        ADDN    e2, e0, e3                      ; by s
        ADDN    e5, t4, e5                      ; by t
        ADDN    e6, t5, t7                      ; by s
        ADDN    t8, pb2, t8                     ; by t
        MPYS    e2, candidate_s, e2
        MPYS    e4, candidate_t, t3
        MPYS    e6, candidate_s, e6
        MPYS    pb2, candidate_t, t4
        ADDN    pa0, e2, e2
        ADDN    pb0, e6, e6
        MPYS    e3, t8, t9
        MPYS    e5, t7, t5
        ADDN    e2, t3, e2                      ; the first conic
        ADDN    e6, t4, e6                      ; the second
        SUBN    t9, t5, t9                      ; determinant
        MPYS    e2, t8, e0
        MPYS    e6, e5, t3
        MPYS    e6, e3, e1
        MPYS    e2, t7, t4
        SUBN    e0, t3, e0
        SUBN    e1, t4, e1
        DIVS    e0, t9, e0
        DIVS    e1, t9, e1
        SUBN    candidate_s, e0, candidate_s
        SUBN    candidate_t, e1, candidate_t
        .endm

        .macro  enter_patch routine, wanted
        enter_solver 6, patch_save, PATCH_REGISTERS
        EX      candidate_routine, \routine
        ES      crossings_wanted, \wanted
        .endm

; Sets all crossings to big.
        .macro  clear_crossings
        RTOR    a_segment, point_at
        .rept   PATCH_CROSSINGS
        STO     [point_at], big
        IX      point_at, 64
        .endr
        RTOR    a_primitive, point_at
        IX      point_at, 64 * P_PATCH_POINTS
        RTOR    crossings_wanted, crossings_left
        .endm

        .macro  steiner_ray rational
        SUBN    ox, sh0, t5
        SUBN    oy, sh1, t6
        SUBN    oz, sh2, t7
        find_lanes t5, t6, t7, sh3, steiner_miss
        RTOR    a_primitive, t3
        IX      t3, 64 * P_TABLE
        LOD     [t3], t3
        ELEN    t3, PATCH_TABLE
        SWAP    [t3], kx0, [r0]
        EX      t3, patch_numbers
        ELEN    t3, 4
        SWAP    [t3], quarter, [r0]
        planes  \rational
        conics  \rational
        .endm

        .kernel steiner
rational_steiner_crossings:
        enter_patch rational_crossing, PATCH_CROSSINGS
        clear_crossings
        BIM     steiner_rational
rational_steiner:
        enter_patch rational_candidate, 0
steiner_rational:
        steiner_ray 1
        BIM     steiner_eliminate
steiner_crossings:
        enter_patch polynomial_crossing, PATCH_CROSSINGS
        clear_crossings
        BIM     steiner_polynomial
steiner:
        enter_patch polynomial_candidate, 0
steiner_polynomial:
        steiner_ray 0
steiner_eliminate:
        eliminate
        bernstein_signs steiner_miss
        RTOR    near_low, patch_least
        EX      t3, patch_limits
        ELEN    t3, 3
        SWAP    [t3], near_low, [r0]
        RTOR    near_low, patch_low
        RTOR    near_high, patch_high
        EX      t3, near_input
        ELEN    t3, 8
        SWAP    [r0], k4, [t3]
        call    solve_quartic_all, near_list
        EX      root_at, near_roots
        IX      root_at, 64 * 4
        LOD     [root_at], roots_left
        EX      root_at, near_roots
        RTOR    big, tin

; One pass per root.
steiner_root:
        CFPGE   r0, roots_left, steiner_done
        LOD     [root_at], candidate_s
        IX      root_at, 64
        SUBN    roots_left, one, roots_left
        MPYS    pb3, candidate_s, e0
        MPYS    pb4, candidate_s, e1
        ADDN    e0, pb1, e0
        ADDN    e1, pb2, e1                     ; B(s)
        MPYS    e0, candidate_s, e0
        ADDN    e0, pb0, e0                     ; B0(s)
        MPYS    e1, e1, e2
        MPYS    e0, e0, e3
        CFPLT   spread, e2, steiner_plain
        CFPGE   spread, e3, steiner_lines
steiner_plain:
        SUBN    r0, e0, e0
        DIVS    e0, e1, candidate_t
        BSAVE   patch_link, [candidate_routine]
        BIM     steiner_root
steiner_done:
        CFPGE   tin, big, steiner_miss
        RTOR    tin, tout
        IX      a_primitive, 64 * P_PATCH_POINT
        STO     [a_primitive], patch_s
        STO     [a_primitive, index_one], patch_t
        leave_solver patch_save, PATCH_REGISTERS
steiner_miss:
        IBXNE   crossings_wanted, r0, r0, steiner_stored
        miss_near patch_save, PATCH_REGISTERS
steiner_stored:
        leave_segments patch_save, PATCH_REGISTERS

; The second conic is a pair of lines: t is a root of the first conic.
steiner_lines:
        MPYS    pa4, candidate_s, e1
        MPYS    pa3, candidate_s, e0
        ADDN    e1, pa2, e1
        ADDN    e0, pa1, e0
        MPYS    e1, m_half, e1
        MPYS    e0, candidate_s, e0
        ADDN    e0, pa0, e0
        discriminant pa5, e1, e0, t3, t4
        SQRT    t3, t4
        ABS     e1, g0
        ADDN    g0, t4, t4
        CFPLT   e1, r0, steiner_signed
        SUBN    r0, t4, t4
steiner_signed:
        DIVS    e0, t4, g1
        DIVS    t4, pa5, candidate_t
        RTOR    candidate_s, g2
        EX      t3, steiner_newton
        BSAVE   patch_link, [t3]
        RTOR    g2, candidate_s
        RTOR    g1, candidate_t
        EX      t3, steiner_newton
        BSAVE   patch_link, [t3]
        BIM     steiner_root
steiner_newton:
        .rept   3
        newton_step
        .endr
        ABS     e0, e0
        ABS     e1, e1
        ADDN    e0, e1, e0
        CFPLT   e0, last_step, steiner_settled
steiner_lost:
        BIM     0, patch_link
steiner_settled:
        CFPLT   candidate_s, patch_low, steiner_lost
        BIM     0, candidate_routine

polynomial_candidate:
        patch_candidate 0
rational_candidate:
        patch_candidate 1
polynomial_crossing:
        patch_crossing 0
rational_crossing:
        patch_crossing 1
        .endkernel

        .ifdef  HISTORICAL
        .include "shapes/steiner_implicit_scalar.s"
        .endif
