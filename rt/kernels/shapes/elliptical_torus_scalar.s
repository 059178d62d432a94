; elliptical_torus_scalar.s - intersects one ray with an elliptical torus about
; the y axis; also the part that all tori share after the polynomial.
;
;       CALL ELLIPTICAL_TORUS (RAY, PRIMITIVE, SEGMENT)
;       CALL ELLIPTICAL_TORUS_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; The arguments are those of torus_scalar.s, the method is that of
; torus_vector.s.

        .macro  elliptical_polynomial
        MPYS    dx, dx, e0
        MPYS    dz, dz, t3
        MPYS    t0, dx, e1
        MPYS    t2, dz, t4
        MPYS    t0, t0, e2
        MPYS    t2, t2, t5
        ADDN    t3, e0, e0                      ; f
        ADDN    t4, e1, e1                      ; l
        ADDN    t5, e2, e2                      ; g
        MPYS    dy, dy, e3
        MPYS    t1, dy, e4
        MPYS    t1, t1, e5
        MPYS    e3, sh0, e3
        MPYS    e4, sh0, e4
        MPYS    e5, sh0, e5
        ADDN    e3, e0, e3                      ; a
        ADDN    e4, e1, e4
        ADDN    e5, e2, e5
        ADDN    e4, e4, e4                      ; b
        ADDN    e5, sh1, e5                     ; c
        MPYS    e3, e3, k4
        MPYS    e3, e4, k3
        MPYS    e3, e5, k2
        MPYS    e4, e4, t3
        MPYS    e4, e5, k1
        MPYS    e5, e5, k0
        ADDN    k3, k3, k3
        ADDN    k2, k2, k2
        ADDN    k1, k1, k1
        MPYS    e0, sh2, t4
        MPYS    e1, sh7, t5
        MPYS    e2, sh2, t6
        ADDN    t3, k2, k2
        SUBN    k1, t5, k1
        SUBN    k0, t6, k0
        SUBN    k2, t4, k2
        .endm

        .kernel torus
elliptical_torus:
        enter_solver 10
        clip_to_bound ox, oy, oz, sh4, torus_miss
        leave_above torus_miss
        elliptical_polynomial
        solve_near sh8, torus_miss
        leave_solver

elliptical_torus_solid:
        enter_solver 10
        clip_line_to_bound ox, oy, oz, sh4, torus_passed
        leave_above torus_passed
        elliptical_polynomial
torus_segments:
        solve_all sh8
        BIM     torus_solved
torus_passed:
        ADDN    r0, r0, e0
torus_solved:
        ES      e4, 0
        give_segments 4
        leave_segments
        .endkernel
