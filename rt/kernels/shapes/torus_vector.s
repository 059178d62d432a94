; torus_vector.s - intersects a queue of rays with a torus about the y axis.
;
; Elliptical: R is the major radius, p and n are the half axes of the tube,
; perpendicular to the axis and along it; rho = p^2/n^2, b0 = R^2 - p^2, a0 = 4
; R^2:
;
;   (x^2 + z^2 + rho y^2 + b0)^2 = a0 (x^2 + z^2)
;
; With o, the ray's closest approach to the centre, as its origin,
;
;   f = dx^2 + dz^2      l = ox dx + oz dz     g = ox^2 + oz^2
;   a = f + rho dy^2     b = 2 (l + rho oy dy) c = g + rho oy^2 + b0
;
; both sides are polynomials in the distance s from o:
;
;   (a s^2 + b s + c)^2 = a0 (f s^2 + 2 l s + g)
;
; Circular (p = n = r): the cubic term vanishes because o . d = 0, and with
; k = o . o - R^2 - r^2
;
;   s^4 + (2 k + a0 dy^2) s^2 + 2 a0 oy dy s + k^2 + a0 (oy^2 - r^2) = 0
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      torus_solid: two segments (segments_vector.s).
; Source: the project's notes on ray tracing, 1.1.

        include_form lanes

; Removes rays that stay above or below the torus: y > sh9 or y < -sh9 at both
; ends.
        .macro  leave_above miss
        MPYSV   [w5], [dy], [w8]
        ADDNV   [w8], [w1], [w8]
        MPYSV   [w6], [dy], [w9]
        ADDNV   [w9], [w1], [w9]
        SUBN    r0, sh9, s0
        CMPLTV  sh9, [w8], [bits1]
        CMPLTV  sh9, [w9], [bits2]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits0], [bits1], [bits0]
        CMPLTV  [w8], s0, [bits1]
        CMPLTV  [w9], s0, [bits2]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits0], [bits1], [bits0]
        CNTOB   [bits0], m
        IBXEQ   m, r0, r0, \miss
        .endm

; Computes the quartics of the lanes.
        .macro  torus_polynomial
        CPSV    [w7], [e0] ? [bits0]
        SUBNV   [e0], sh5, [e0]                 ; k
        MPYSV   [lane_dy], [lane_dy], [e1]
        ADDNV   [e0], [e0], [e2]
        LINKV
        MPYSV   [e1], sh2, [e1]
        ADDNV   [e1], [e2], [k2]
        MPYSV   [lane_oy], [lane_dy], [e1]
        MPYSV   [e1], sh7, [k1]
        MPYSV   [lane_oy], [lane_oy], [e1]
        LINKV
        SUBNV   [e1], sh6, [e1]
        MPYSV   [e1], sh2, [e1]
        MPYSV   [e0], [e0], [e2]
        ADDNV   [e1], [e2], [k0]
        VTOV    r0, [k3]
        VTOV    one, [k4]
        .endm

        .kernel torus
torus:
        load_record P_SHAPE, 10, sh0
        find_lanes ox, oy, oz, sh4, torus_miss
        leave_above torus_miss
        take_lanes
        torus_polynomial
        solve_lanes sh8
        BIM     0, link_kernel
torus_miss:
        miss_all

torus_solid:
        load_record P_SHAPE, 10, sh0
        find_all_lanes ox, oy, oz, sh4, torus_passed
        leave_above torus_passed
        take_lanes
        torus_polynomial
        solve_segments sh8
        BIM     0, link_kernel
torus_passed:
        no_segments
        BIM     0, link_kernel
        .endkernel
