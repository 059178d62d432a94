; quartic_scalar.s - intersects one ray with a quartic surface.
;
;       CALL QUARTIC_SURFACE (RAY, PRIMITIVE, SEGMENT)
;       CALL QUARTIC_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; quartic_vector.s.  SEGMENTS receives three segments (6 words) of the ray
; inside, where the polynomial is below 0 (segments_scalar.s).

        .ifndef LANE_REGISTERS
        .include "shapes/lanes_scalar.s"
        .endif
        .include "shapes/quartic_terms.s"

        .share  local
        .regs   r91, a0, a1, a2, a3, a4, b0, b1, b2, b3, b4
        .regs   r101, z20, z21, z22, z30, z31, z32, z33, z40, z41, z42, z43
        .regs   r112, z44, table_at, used_terms, used_groups
        .endshare
        .equ    SURFACE_REGISTERS, 84

        .data
surface_save:   .space SURFACE_REGISTERS
        .code

        .macro  term0 c
        CFPEQ   \c, r0, term_none\@
        ADDN    a0, \c, a0
        ES      used_terms, 1
term_none\@:
        .endm

        .macro  term1 c
        CFPEQ   \c, r0, term_none\@
        MPYS    t2, \c, b0
        MPYS    dz, \c, b1
        ES      used_terms, 1
        ADDN    b0, a0, a0
        ADDN    b1, a1, a1
term_none\@:
        .endm

        .macro  term2 c
        CFPEQ   \c, r0, term_none\@
        MPYS    z20, \c, b0
        MPYS    z21, \c, b1
        MPYS    z22, \c, b2
        ES      used_terms, 1
        ADDN    b0, a0, a0
        ADDN    b1, a1, a1
        ADDN    b2, a2, a2
term_none\@:
        .endm

        .macro  term3 c
        CFPEQ   \c, r0, term_none\@
        MPYS    z30, \c, b0
        MPYS    z31, \c, b1
        MPYS    z32, \c, b2
        MPYS    z33, \c, b3
        ES      used_terms, 1
        ADDN    b0, a0, a0
        ADDN    b1, a1, a1
        ADDN    b2, a2, a2
        ADDN    b3, a3, a3
term_none\@:
        .endm

        .macro  term4 c
        CFPEQ   \c, r0, term_none\@
        MPYS    z40, \c, b0
        MPYS    z41, \c, b1
        MPYS    z42, \c, b2
        MPYS    z43, \c, b3
        MPYS    z44, \c, b4
        ES      used_terms, 1
        ADDN    b0, a0, a0
        ADDN    b1, a1, a1
        ADDN    b2, a2, a2
        ADDN    b3, a3, a3
        ADDN    b4, a4, a4
term_none\@:
        .endm

        .macro  multiply o, d, degree, c0, c1, c2, c3, c4
        MPYS    \c0, \d, b0
        .if     \degree >= 2
        MPYS    \c1, \d, b1
        .endif
        .if     \degree >= 3
        MPYS    \c2, \d, b2
        .endif
        .if     \degree >= 4
        MPYS    \c3, \d, b3
        .endif
        MPYS    \c0, \o, \c0
        .if     \degree >= 2
        MPYS    \c1, \o, \c1
        .endif
        .if     \degree >= 3
        MPYS    \c2, \o, \c2
        .endif
        .if     \degree >= 4
        MPYS    \c3, \o, \c3
        ADDN    b0, \c1, \c1
        ADDN    b1, \c2, \c2
        ADDN    b2, \c3, \c3
        RTOR    b3, \c4
        .elseif \degree == 3
        ADDN    b0, \c1, \c1
        ADDN    b1, \c2, \c2
        RTOR    b2, \c3
        .elseif \degree == 2
        ADDN    b0, \c1, \c1
        RTOR    b1, \c2
        .elseif \degree == 1
        RTOR    b0, \c1
        .endif
        .endm

        .macro  times_y degree
        IBXEQ   used_terms, r0, r0, times_none\@
        multiply t1, dy, \degree, a0, a1, a2, a3, a4
times_none\@:
        .endm

        .macro  times_x degree
        multiply t0, dx, \degree, k0, k1, k2, k3, k4
        .endm

        .macro  clear_group degree
        ADDN    r0, r0, a0
        ADDN    r0, r0, a1
        ADDN    r0, r0, a2
        ADDN    r0, r0, a3
        ADDN    r0, r0, a4
        .endm

        .macro  add_group degree
        ADDN    k0, a0, k0
        .if     \degree >= 1
        ADDN    k1, a1, k1
        .endif
        .if     \degree >= 2
        ADDN    k2, a2, k2
        .endif
        .if     \degree >= 3
        ADDN    k3, a3, k3
        .endif
        .if     \degree >= 4
        ADDN    k4, a4, k4
        .endif
        .endm

        .macro  power_of_z
        MPYS    t2, t2, z20
        MPYS    t2, dz, z21
        MPYS    dz, dz, z22
        ADDN    z21, z21, z21
        MPYS    z20, t2, z30
        MPYS    z20, dz, b0
        MPYS    z22, t2, z32
        MPYS    z21, t2, z31
        MPYS    z21, dz, b1
        MPYS    z22, dz, z33
        MPYS    z30, t2, z40
        MPYS    z30, dz, b2
        ADDN    b0, z31, z31
        ADDN    b1, z32, z32
        MPYS    z33, t2, z43
        MPYS    z33, dz, z44
        MPYS    z31, t2, z41
        MPYS    z31, dz, b3
        MPYS    z32, t2, z42
        MPYS    z32, dz, b4
        ADDN    b2, z41, z41
        ADDN    b3, z42, z42
        ADDN    b4, z43, z43
        .endm

        .macro  at_least x, most
        CFPGE   \most, \x, at_least\@
        RTOR    \x, \most
at_least\@:
        .endm

        .macro  horner_step k
        MPYS    e0, near_low, e0
        ADDN    e0, \k, e0
        .endm

; Computes k4 .. k0 about the closest approach, and near_high, which no root
; exceeds.
        .macro  surface_polynomial
        closest_approach ox, oy, oz, t0, t1, t2, along, t3, t4
        power_of_z
        ADDN    r0, r0, k0
        ADDN    r0, r0, k1
        ADDN    r0, r0, k2
        ADDN    r0, r0, k3
        ADDN    r0, r0, k4
        RTOR    sh0, e0                         ; 1e7
        RTOR    sh1, near_resolution
        IX      a_primitive, 64 * P_TABLE
        LOD     [a_primitive], table_at
        quartic_groups
        RTOR    e0, near_high
        CFPEQ   k4, r0, surface_high\@
        ABS     k4, e1
        DIVS    one, e1, e1
        ABS     k3, e2
        ABS     k2, e3
        ABS     k0, e4
        ABS     k1, e5
        MPYS    e2, e1, e2
        MPYS    e3, e1, e3
        MPYS    e4, e1, e4
        MPYS    e5, e1, e5
        RTOR    one, near_high
        at_least e2, near_high
        SQRT    e3, e3
        at_least e3, near_high
        SQRT    e4, e4
        SQRT    e4, e4
        at_least e4, near_high
        DIVS    e5, near_high, e5
        SQRT    e5, e5
        at_least e5, near_high
        ADDN    near_high, near_high, near_high
        CFPGE   e0, near_high, surface_high\@
        RTOR    e0, near_high
surface_high\@:
        .endm

        .kernel quartic_surface
quartic_surface:
        enter_solver 2, surface_save, SURFACE_REGISTERS
        surface_polynomial
        ADDN    lower, along, near_low
        SUBN    r0, near_high, t3
        CFPLT   t3, near_low, surface_ahead
        RTOR    t3, near_low
surface_ahead:
        solve_near near_resolution, surface_miss
        leave_solver surface_save, SURFACE_REGISTERS
surface_miss:
        miss_near surface_save, SURFACE_REGISTERS

quartic_solid:
        enter_solver 2, surface_save, SURFACE_REGISTERS
        surface_polynomial
        SUBN    r0, near_high, near_low
        MPYS    k4, near_low, e0
        ADDN    e0, k3, e0
        horner_step k2
        horner_step k1
        horner_step k0
        ES      e4, 0
        CFPGE   e0, r0, surface_begins
        ES      e4, 1
surface_begins:
        solve_all near_resolution
        give_segments 6
        leave_segments surface_save, SURFACE_REGISTERS
        .endkernel
