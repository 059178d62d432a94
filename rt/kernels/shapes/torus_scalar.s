; torus_scalar.s - one ray meets a torus about the y axis.
;
;       CALL TORUS (RAY, PRIMITIVE, SEGMENT)
;       CALL ELLIPTICAL_TORUS (RAY, PRIMITIVE, SEGMENT)
;       CALL TORUS_SOLID (RAY, PRIMITIVE, SEGMENTS)
;       CALL ELLIPTICAL_TORUS_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; Arguments as in sphere_scalar.s, method as in torus_vector.s.  SEGMENTS = the
; ray's way inside (segments_scalar.s), two of them (4 words).

; To miss if the ray stays above the torus or below it.
        .macro  leave_above miss
        MPYS    near_low, dy, e0
        MPYS    near_high, dy, e1
        SUBN    r0, sh9, e2
        ADDN    e0, t1, e0
        ADDN    e1, t1, e1
        CFPGE   sh9, e0, leave_below\@
        CFPLT   sh9, e1, \miss
leave_below\@:
        CFPGE   e0, e2, leave_not\@
        CFPLT   e1, e2, \miss
leave_not\@:
        .endm

        .macro  torus_polynomial
        SUBN    near_o2, sh5, e0                ; k
        MPYS    dy, dy, e1
        MPYS    t1, dy, e3
        MPYS    t1, t1, e4
        ADDN    e0, e0, e2
        MPYS    e1, sh2, e1
        MPYS    e3, sh7, k1
        SUBN    e4, sh6, e4
        MPYS    e0, e0, e0
        ADDN    e1, e2, k2
        MPYS    e4, sh2, e4
        ADDN    r0, r0, k3
        RTOR    one, k4
        ADDN    e4, e0, k0
        .endm

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
torus:
        enter_solver 10
        come_near ox, oy, oz, sh4, torus_miss
        leave_above torus_miss
        torus_polynomial
        solve_near sh8, torus_miss
        leave_solver
elliptical_torus:
        enter_solver 10
        come_near ox, oy, oz, sh4, torus_miss
        leave_above torus_miss
        elliptical_polynomial
        solve_near sh8, torus_miss
        leave_solver
torus_miss:
        miss_near

torus_solid:
        enter_solver 10
        come_anywhere ox, oy, oz, sh4, torus_passed
        leave_above torus_passed
        torus_polynomial
        BIM     torus_segments
elliptical_torus_solid:
        enter_solver 10
        come_anywhere ox, oy, oz, sh4, torus_passed
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
