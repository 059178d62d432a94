; quadric_scalar.s - intersects one ray with a quadric.
;
;       CALL QUADRIC (RAY, PRIMITIVE, SEGMENT)
;       CALL QUADRIC_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; quadric_vector.s.  SEGMENTS receives two segments (4 words) of the ray inside,
; where the polynomial is below 0.

        shape_from r62                  ; after quad_c
        .equ    QUADRIC_REGISTERS, 41

        .data
quadric_save:   .space QUADRIC_REGISTERS
        .code
; Computes a, b, c, and t2 = b^2 - a c.
        .macro  quadric_polynomial
        SUBN    ox, sh0, t0
        SUBN    oy, sh1, t1
        SUBN    oz, sh2, t2
        closest_approach t0, t1, t2, t0, t1, t2, shift, t3, t4
        matrix_rows dx, dy, dz, t7, t8, t9, t3, t4, t5, t6
        dot     dx, dy, dz, t7, t8, t9, quad_a, t3
        matrix_rows t0, t1, t2, t7, t8, t9, t3, t4, t5, t6
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
        .endm

        .kernel quadric
quadric:
        enter_kernel quadric_save, QUADRIC_REGISTERS, 13, index_one
        quadric_polynomial
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
        leave_kernel index_one
quadric_miss:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel index_one

; Two crossings: the ray is inside between them or, if a < 0, before the first
; and after the second.  One crossing: it is inside before it if the polynomial
; rises.  None: it is inside everywhere or nowhere.
quadric_solid:
        enter_kernel quadric_save, QUADRIC_REGISTERS, 13, index_one
        quadric_polynomial
        RTOR    big, t8
        RTOR    minus_big, t9
        CFPLT   t2, r0, solid_uncrossed
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1, solid_one, solid_double
        sort_roots t0, t1
solid_two:
        move_back shift
        CFPGE   quad_a, r0, solid_stored
        RTOR    tin, t7
        RTOR    tout, t8
        RTOR    big, t9
        RTOR    minus_big, tin
        RTOR    t7, tout
        BIM     solid_stored
solid_double:
        CFPEQ   quad_a, r0, solid_constant
        DIVS    t2, quad_a, tin
        RTOR    tin, tout
        BIM     solid_two
solid_one:
        SUBN    t1, shift, t1
        RTOR    minus_big, tin
        RTOR    t1, tout
        CFPGE   quad_b, r0, solid_stored
        RTOR    t1, tin
        RTOR    big, tout
        BIM     solid_stored
solid_constant:
        RTOR    quad_c, quad_a
solid_uncrossed:
        RTOR    big, tin
        RTOR    minus_big, tout
        CFPGE   quad_a, r0, solid_stored
        RTOR    minus_big, tin
        RTOR    big, tout
solid_stored:
        ES      t7, 2
        STO     [a_segment, t7], t8
        IX      t7, 1
        STO     [a_segment, t7], t9
        leave_kernel index_one
        .endkernel
