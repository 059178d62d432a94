; elliptical_torus.s - intersects rays with an elliptical torus about the y
; axis.  Formulas, arguments and results are those of torus.s.
;
; Record: that of torus.s.

        .macro  elliptical_polynomial
        ray_times near_dx, near_dx, e0
        ray_times near_dz, near_dz, e3
        ray_times near_ox, near_dx, e1
        ray_times near_oz, near_dz, e4
        ray_times near_ox, near_ox, e2
        ray_times near_oz, near_oz, e5
        ray_plus e3, e0, e0                     ; f
        ray_plus e4, e1, e1                     ; l
        ray_plus e5, e2, e2                     ; g
        ray_times near_dy, near_dy, e3
        ray_times near_oy, near_dy, e4
        ray_times near_oy, near_oy, e5
        ray_scaled_plus e3, sh0, e0, e3         ; a
        ray_scaled_plus e4, sh0, e1, e4
        ray_scaled_plus e5, sh0, e2, e5
        ray_plus e4, e4, e4                     ; b
        ray_raise e5, sh1, e5                   ; c
        ray_times e3, e3, k4
        ray_product_double e3, e4, k3
        ray_product_double e3, e5, k2
        ray_times e4, e4, e6
        ray_product_double e4, e5, k1
        ray_plus e6, k2, k2
        ray_minus_scaled k1, e1, sh7, k1
        ray_times e5, e5, k0
        ray_minus_scaled k2, e0, sh2, k2
        ray_minus_scaled k0, e2, sh2, k0
        .endm

        .kernel torus
elliptical_torus:
        enter_lanes 10
        find_lanes ox, oy, oz, sh4, torus_miss
        leave_above torus_miss
        take_lanes
        elliptical_polynomial
        leave_at_root sh8, torus_miss

elliptical_torus_solid:
        enter_lanes 10
        find_all_lanes ox, oy, oz, sh4, torus_passed
        leave_above torus_passed
        take_lanes
        elliptical_polynomial
torus_segments:
        leave_with_segments sh8, torus_passed
        .endkernel
