; quadric_scalar.s - one ray meets a quadric.
;
;       CALL QUADRIC (RAY, PRIMITIVE, SEGMENT)
;
; Arguments as in sphere_scalar.s, method as in quadric_vector.s.

        .macro  quadric_rows x0, x1, x2, y0, y1, y2, w0, w1, w2, w3
        dot_rows \x0, \x1, \x2, sh3, sh6, sh7, sh6, sh4, sh8, sh7, sh8, sh5, \y0, \y1, \y2, \w0, \w1, \w2, \w3
        .endm

        .data
quadric_save:   .space QUADRATIC_REGISTERS
        .code
        .kernel quadric
quadric:
        enter_kernel quadric_save, QUADRATIC_REGISTERS, 13
        SUBN    ox, sh0, t0
        SUBN    oy, sh1, t1
        SUBN    oz, sh2, t2
        closest_approach t0, t1, t2, t0, t1, t2, shift, t3, t4
        quadric_rows dx, dy, dz, t7, t8, t9, t3, t4, t5, t6
        dot     dx, dy, dz, t7, t8, t9, quad_a, t3
        quadric_rows t0, t1, t2, t7, t8, t9, t3, t4, t5, t6
        ADDN    t7, sh9, t7
        ADDN    t8, sh10, t8
        ADDN    t9, sh11, t9
        dot     dx, dy, dz, t7, t8, t9, quad_b, t3
        ADDN    t7, sh9, t7
        ADDN    t8, sh10, t8
        ADDN    t9, sh11, t9
        dot     t0, t1, t2, t7, t8, t9, quad_c, t3
        ADDN    quad_c, sh12, quad_c
        discriminant quad_a, quad_b, quad_c, t2, t0
        CFPLT   t2, r0, quadric_miss
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1, quadric_one, quadric_double
        sort_roots t0, t1
        BIM     quadric_crossed
quadric_double:
        CFPEQ   quad_a, r0, quadric_miss
        DIVS    t2, quad_a, t1
quadric_one:
        RTOR    t1, tin
        RTOR    t1, tout
quadric_crossed:
        move_back shift
        leave_kernel quadric_save, QUADRATIC_REGISTERS
quadric_miss:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel quadric_save, QUADRATIC_REGISTERS
        .endkernel
