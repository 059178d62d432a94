; quartic_scalar.s - the scalar form of the quartic surface.

        .share  local
        .regs   r91, a0, a1, a2, a3, a4, b0, b1, b2
        .regs   r99, z20, z21, z22, z30, z31, z32, z33, z40, z41, z42, z43
        .regs   r110, z44, table_at, used_terms, used_groups
        .endshare
        .reg    surface_along, along
        .reg    surface_low, near_low
        .reg    surface_high, near_high
        .equ    SURFACE_REGISTERS, 82

        .data
surface_save:   .space SURFACE_REGISTERS
        .code

        .macro  enter_surface
        enter_solver 2, surface_save, SURFACE_REGISTERS
        .endm

        .macro  load_surface
        RTOR    sh0, e0                         ; 1e7
        RTOR    sh1, near_resolution
        IX      a_primitive, 64 * P_TABLE
        LOD     [a_primitive], table_at
        .endm

; near_high exceeds all roots.
        .macro  find_high
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

        .macro  leave_surface
        ADDN    lower, along, near_low
        SUBN    r0, near_high, t3
        CFPLT   t3, near_low, surface_ahead
        RTOR    t3, near_low
surface_ahead:
        solve_near near_resolution, surface_miss
        leave_solver surface_save, SURFACE_REGISTERS
surface_miss:
        miss_near surface_save, SURFACE_REGISTERS
        .endm

        .macro  leave_solid
        ES      e4, 0
        CFPGE   e0, r0, surface_begins
        ES      e4, 1
surface_begins:
        solve_all near_resolution
        give_segments 6
        leave_segments surface_save, SURFACE_REGISTERS
        .endm
