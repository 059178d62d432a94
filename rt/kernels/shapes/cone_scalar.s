; cone_scalar.s - intersects one ray with a cone or frustum, solid or open.
;
;       CALL CONE (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_CONE (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; cone_vector.s.

        shape_from r65                  ; after k_along
        .equ    CONE_REGISTERS, 48

; Computes tin, tout of the side, or branches to miss.  Also sets o_along and
; d_along, the ray's origin and direction along w; shift, the shift of the
; origin; quad_a = a.  k_along > 0: a ray with a <= 0 ends inside.
        .macro  cone_side miss
        SUBN    ox, sh0, t0
        SUBN    oy, sh1, t1
        SUBN    oz, sh2, t2
        closest_approach t0, t1, t2, t0, t1, t2, shift, t3, t4
        dot_rows t0, t1, t2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, t7, t8, o_along, t3, t4, t5, t6
        dot_rows dx, dy, dz, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, t0, t1, d_along, t3, t4, t5, t6
        MPYS    o_along, sh13, t2
        MPYS    d_along, sh13, k_along
        MPYS    t0, t0, quad_a
        MPYS    t1, t1, t4
        MPYS    t7, t0, quad_b
        ADDN    t2, sh12, t2            ; r(ow)
        MPYS    t8, t1, t5
        ADDN    t4, quad_a, quad_a
        MPYS    k_along, k_along, t4
        MPYS    t7, t7, quad_c
        MPYS    t8, t8, t6
        ADDN    t5, quad_b, quad_b
        MPYS    t2, k_along, t5
        MPYS    t2, t2, t2
        SUBN    quad_a, t4, quad_a            ; a
        ADDN    t6, quad_c, quad_c
        SUBN    quad_b, t5, quad_b            ; b
        SUBN    quad_c, t2, quad_c            ; c
        discriminant quad_a, quad_b, quad_c, t2, t0
        CFPGE   t2, r0, cone_real\@
        CFPGE   quad_a, r0, \miss
        ADDN    r0, r0, t2
cone_real\@:
        quadratic_roots quad_a, quad_b, quad_c, t2, t0, t1, cone_one\@, cone_double\@
        sort_roots t0, t1
        BIM     cone_sided\@
cone_one\@:
        SUBN    r0, quad_b, k_along
        RTOR    t1, tin
        RTOR    t1, tout
        BIM     cone_sided\@
cone_double\@:
        DIVS    t2, quad_a, tin
        RTOR    tin, tout
        CFPNE   quad_a, r0, cone_sided\@
        CFPLT   r0, quad_c, \miss
        RTOR    minus_big, tin
        RTOR    big, tout
        RTOR    one, quad_a
cone_sided\@:
        .endm

        .data
cone_save:      .space CONE_REGISTERS
        .code
        .kernel cone
cone:
        enter_kernel cone_save, CONE_REGISTERS, 15
        cone_side cone_miss
        CFPLT   r0, quad_a, cone_cut
        CFPLT   r0, k_along, cone_goes
        RTOR    tin, tout
        RTOR    minus_big, tin
        BIM     cone_cut
cone_goes:
        RTOR    tout, tin
        RTOR    big, tout
cone_cut:
        SUBN    r0, sh14, t9
        slab    o_along, d_along, t9, sh14, cone_miss
        move_back shift
        leave_kernel
cone_miss:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel

open_cone:
        enter_kernel cone_save, CONE_REGISTERS, 15
        cone_side cone_miss
        keep_between_disks o_along, d_along, sh14, cone_miss
        move_back shift
        leave_kernel
        .endkernel
