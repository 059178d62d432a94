; quartic_vector.s - the vector form of the quartic surface.

        .reg    table_at, s1
        .reg    used_terms, s2
        .reg    used_groups, s3
        .regs   lane_ox, z20, z21, z22, z30, z31, z32, z33, z40
        .regs   e0, z41, z42, z43, z44, a0, a1, a2, a3, a4, b0, b1, b2
        .reg    surface_along, w3
        .reg    surface_low, w6
        .reg    surface_high, w5

        .macro  enter_surface
        set_lanes near
        .endm

        .macro  load_surface
        load_field P_TABLE, table_at
        .endm

        .macro  find_high
        DIVSV   one, |[k4]|, [w4]
        MPYSV   |[k3]|, [w4], [w6]
        VTOV    one, [w5]
        ray_not_below w6, w5
        LINKV
        MPYSV   |[k2]|, [w4], [w6]
        SQRTV   [w6], [w6]
        ray_not_below w6, w5
        LINKV
        MPYSV   |[k0]|, [w4], [w6]
        SQRTV   [w6], [w6]
        SQRTV   [w6], [w6]
        ray_not_below w6, w5
        MPYSV   |[k1]|, [w4], [w6]
        DIVSV   [w6], [w5], [w6]
        SQRTV   [w6], [w6]
        ray_not_below w6, w5
        ADDNV   [w5], [w5], [w5]
        load_record P_SHAPE, 2, sh0             ; 1e7, resolution
        CMPEQV  [k4], r0, [bits0]
        VTOV    sh0, [w5] ? [bits0]
        CMPLTV  sh0, [w5], [bits0]
        VTOV    sh0, [w5] ? [bits0]
        .endm

        .macro  leave_surface
        ADDNV   [lower], [w3], [w6]
        CMPGEV  -[w6], [w5], [bits0]
        VTOV    -[w5], [w6] ? [bits0]
        solve_quartics solve_quartic, w6, w5, sh1
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        CMPLTV  [root0], big, [bits0]
        SUBNV   [root0], [w3], [tin] ? [bits0]
        VTOV    [tin], [tout] ? [bits0]
        BIM     0, link_kernel
        .endm

; [to] = [before] in the lanes of hits2, where the ray begins inside, else
; [crossing].  This moves the crossings by one place; minus_big becomes the
; first.
        .macro  begin_inside crossing, before, to
        MASKV   [\before], [\crossing], [\to] ? [hits2]
        .endm

        .macro  leave_solid
        CMPLTV  [e0], r0, [hits2]
        solve_all w6, w5, sh1
        SUBNV   [root0], [w3], [root0]
        SUBNV   [root1], [w3], [root1]
        SUBNV   [root2], [w3], [root2]
        SUBNV   [root3], [w3], [root3]
        ADDNV   [root_count], one, [root_count] ? [hits2]
        begin_inside root3, root2, e3
        begin_inside root2, root1, e2
        begin_inside root1, root0, e1
        VTOV    minus_big, [root0] ? [hits2]
        ADDN    one, two, s0
        ADDN    two, two, s2
        ADDN    s0, two, s3
        entry_or_none root0, r0, tin
        exit_or_none e1, one, tout
        entry_or_none e2, two, tin2
        exit_or_none e3, s0, tout2
        entry_or_none root3, s2, tin3
        exit_or_none root3, s3, tout3
        BIM     0, link_kernel
        .endm
