; torus.s - intersects rays with a torus about the y axis.
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
;       CALL TORUS (RAY, PRIMITIVE, SEGMENT)
;       CALL TORUS_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; In:  ox oy oz dx dy dz lower, near long; the primitive's record.
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      torus_solid: two segments (segments_vector.s).
; Record: rho, b0, a0, a0/2, square of its bound, R^2 + r^2, r^2, 2 a0,
;         resolution of its roots, half distance of the planes about it.
; Source: the project's notes on ray tracing, 1.1.

        include_form lanes
        include_form torus

        .kernel torus
torus:
        enter_lanes 10
        find_lanes ox, oy, oz, sh4, torus_miss
        leave_above torus_miss
        take_lanes
        torus_polynomial
        leave_at_root sh8, torus_miss
torus_miss:
        miss_near

torus_solid:
        enter_lanes 10
        find_all_lanes ox, oy, oz, sh4, torus_passed
        leave_above torus_passed
        take_lanes
        torus_polynomial
        BIM     torus_segments
        .endkernel
