; cylinder_clipped_scalar.s - intersects one ray with a cylinder by the distance
; between ray and axis, then clips it by two planes.
;
;       CALL CLIPPED_CYLINDER (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_CLIPPED_CYLINDER (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; cylinder_clipped_vector.s.  The surfaces of entry and exit are written to
; P_PATCH_POINT of the primitive.

        .share  local
        .regs   r58, across0, across1, across2, surface_in, surface_out
        .endshare
        shape_from r63
        .equ    CLIPPED_REGISTERS, 46

        .data
clipped_save:   .space CLIPPED_REGISTERS
        .code

        .macro  record_surface surface, where
        .ifndef CYLINDER_UNRECORDED
        RTOR    \surface, \where
        .endif
        .endm

        .macro  length x0, x1, x2, sum, work
        dot     \x0, \x1, \x2, \x0, \x1, \x2, \sum, \work
        SQRT    \sum, \sum
        .endm

        .macro  make_unit x0, x1, x2, sum, work
        .ifdef  CYLINDER_RECIPROCALS
        normalise_by one, \x0, \x1, \x2, \sum, \work
        .else
        length  \x0, \x1, \x2, \sum, \work
        DIVS    \x0, \sum, \x0
        DIVS    \x1, \sum, \x1
        DIVS    \x2, \sum, \x2
        .endif
        .endm

        .macro  across_axis x0, x1, x2, c0, c1, c2
        cross_product \x0, \x1, \x2, sh3, sh4, sh5, \c0, \c1, \c2
        .endm

; Computes tin, tout of the infinite cylinder, or branches to miss.  Independent
; operations run during divisions and square roots.
        .macro  find_side miss
        across_axis dx, dy, dz, t0, t1, t2
        SUBN    ox, sh0, t4
        SUBN    oy, sh1, t5
        SUBN    oz, sh2, t6
        length  t0, t1, t2, t3, t8
        across_axis t4, t5, t6, across0, across1, across2
        CFPLT   t3, tiny, side_along\@
        make_unit t0, t1, t2, t7, t8
        dot     t4, t5, t6, t0, t1, t2, t7, t8
        ABS     t7, t7
        CFPLT   sh6, t7, \miss
        dot     across0, across1, across2, t0, t1, t2, t9, t8
        SUBN    r0, t9, t9
        DIVS    t9, t3, across0         ; the closest approach
        across_axis t0, t1, t2, t4, t5, t6
        make_unit t4, t5, t6, t3, t8
        MPYS    t7, t7, t7
        MPYS    sh6, sh6, t8
        SUBN    t8, t7, t7
        SQRT    t7, t7
        dot     dx, dy, dz, t4, t5, t6, t3, t8
        DIVS    t7, t3, t7
        ABS     t7, t7
        SUBN    across0, t7, tin
        ADDN    across0, t7, tout
        BIM     side_crossed\@
side_along\@:
        length  across0, across1, across2, t3, t8
        CFPLT   sh6, t3, \miss
        RTOR    minus_big, tin
        RTOR    big, tout
side_crossed\@:
        record_surface    r0, surface_in
        record_surface    r0, surface_out
        .endm

        .macro  clip p0, p1, p2, q, surface, miss
        MPYS    dx, \p0, t0
        MPYS    dy, \p1, t1
        MPYS    dz, \p2, t2
        MPYS    ox, \p0, t3
        MPYS    oy, \p1, t4
        MPYS    oz, \p2, t5
        ADDN    t1, t0, t0
        ADDN    t4, t3, t3
        ADDN    t2, t0, t0
        ADDN    t5, t3, t3
        ABS     t0, t1
        ADDN    t3, \q, t3
        CFPLT   t1, tiny, clip_parallel\@
        SUBN    r0, t3, t3
        DIVS    t3, t0, t1
        CFPGE   t0, r0, clip_leaves\@
        CFPGE   tin, t1, clip_done\@
        CFPLT   tout, t1, \miss
        RTOR    t1, tin
        record_surface    \surface, surface_in
        BIM     clip_done\@
clip_leaves\@:
        CFPGE   t1, tout, clip_done\@
        CFPLT   t1, tin, \miss
        RTOR    t1, tout
        record_surface    \surface, surface_out
        BIM     clip_done\@
clip_parallel\@:
        CFPLT   r0, t3, \miss
clip_done\@:
        .endm

        .macro  find_clipped miss
        enter_kernel clipped_save, CLIPPED_REGISTERS, 15
        find_side \miss
        clip    sh7, sh8, sh9, sh10, one, \miss
        clip    sh11, sh12, sh13, sh14, m_two, \miss
        .endm

        .kernel cylinder
clipped_cylinder:
        find_clipped clipped_miss
clipped_recorded:
        .ifndef CYLINDER_UNRECORDED
        IX      a_primitive, 64 * (P_PATCH_POINT - P_SHAPE)
        STO     [a_primitive], surface_in
        STO     [a_primitive, index_one], surface_out
        .endif
        leave_kernel
clipped_miss:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel

        .ifndef CYLINDER_UNRECORDED
open_clipped_cylinder:
        find_clipped clipped_miss
        CFPEQ   surface_in, r0, clipped_enters
        CFPNE   surface_out, r0, clipped_miss
        RTOR    tout, tin
        BIM     clipped_recorded
clipped_enters:
        CFPEQ   surface_out, r0, clipped_recorded
        RTOR    tin, tout
        BIM     clipped_recorded
        .endif
        .endkernel
