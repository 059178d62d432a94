; quartic_vector.s - intersects a queue of rays with a quartic surface,
; POV-Ray's quartic with its 35 coefficients.
;
; o is the ray's closest approach to the origin of the shape's space.  The
; quartic in the distance from o is formed by quartic_terms.s.  The surface may
; be unbounded, so crossings are searched up to
;
;   high = 2 max(1, |k3/k4|, |k2/k4|^(1/2), |k0/k4|^(1/4), (|k1/k4| / q)^(1/2))
;
; where q is the maximum of the previous terms.  No root is beyond: if q is less
; than |k1/k4|^(1/3), the last term is greater than that.  high is at most 1e7,
; as in POV-Ray.
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      quartic_solid: three segments (segments_vector.s).
; Source: derived here; the bound is Fujiwara's, without cube roots.

        include_form lanes
        .include "shapes/quartic_terms.s"

        .reg    table_at, s1
        .reg    used_terms, s2
        .reg    used_groups, s3
        .regs   lane_ox, z20, z21, z22, z30, z31, z32, z33, z40
        .regs   e0, z41, z42, z43, z44, a0, a1, a2, a3, a4, b0, b1, b2

        .macro  surface_polynomial
        set_lanes near
        closest_approach ox, oy, oz, w0, w1, w2, w3, w4
        power_of_z
        VTOV    r0, [k0]
        VTOV    r0, [k1]
        VTOV    r0, [k2]
        VTOV    r0, [k3]
        VTOV    r0, [k4]
        load_field P_TABLE, table_at
        quartic_groups
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

        .kernel quartic_surface
quartic_surface:
        surface_polynomial
        ADDNV   [lower], [w3], [w6]
        CMPGEV  -[w6], [w5], [bits0]
        VTOV    -[w5], [w6] ? [bits0]
        RTOR    link_inner, lane_link
        EX      s8, solve_quartic
        call_quartic s8, k4, k3, k2, k1, k0, w6, w5, sh1
        RTOR    lane_link, link_inner
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        CMPLTV  [root0], big, [bits0]
        SUBNV   [root0], [w3], [tin] ? [bits0]
        VTOV    [tin], [tout] ? [bits0]
        BIM     0, link_kernel

; [to] = [before] in the lanes of hits2, where the ray begins inside, else
; [crossing].  This moves the crossings by one place; minus_big becomes the
; first.
        .macro  begin_inside crossing, before, to
        MASKV   [\before], [\crossing], [\to] ? [hits2]
        .endm

        .macro  horner_low k
        MPYSV   [e0], [w6], [e0]
        ADDNV   [e0], [\k], [e0]
        .endm

quartic_solid:
        surface_polynomial
        SUBNV   r0, [w5], [w6]
        MPYSV   [k4], [w6], [e0]
        ADDNV   [e0], [k3], [e0]
        horner_low k2
        horner_low k1
        horner_low k0
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
        .endkernel
