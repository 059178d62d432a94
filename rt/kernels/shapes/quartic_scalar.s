; quartic_scalar.s - intersects one ray with a quartic surface.
;
;       CALL QUARTIC_SURFACE (RAY, PRIMITIVE, SEGMENT)
;       CALL QUARTIC_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; quartic_vector.s.  SEGMENTS receives three segments (6 words) of the ray
; inside, where the polynomial is below 0 (segments_scalar.s).

        include_form lanes
        .include "shapes/quartic_terms.s"

        .share  local
        .regs   r91, a0, a1, a2, a3, a4, b0, b1, b2
        .regs   r99, z20, z21, z22, z30, z31, z32, z33, z40, z41, z42, z43
        .regs   r110, z44, table_at, used_terms, used_groups
        .endshare
        .equ    SURFACE_REGISTERS, 82

        .data
surface_save:   .space SURFACE_REGISTERS
        .code

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
        ray_not_below e2, near_high
        SQRT    e3, e3
        ray_not_below e3, near_high
        SQRT    e4, e4
        SQRT    e4, e4
        ray_not_below e4, near_high
        DIVS    e5, near_high, e5
        SQRT    e5, e5
        ray_not_below e5, near_high
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
