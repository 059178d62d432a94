; cylinder_clipped.s - intersects rays with a cylinder by the
; method that one of the paper's authors published later: the distance between
; ray and axis, then clipping by two planes.  It records the surfaces of entry
; and exit.
;
; With base B, unit axis A and radius r, and a ray from O along D:
;
;   N = D x A,  n = |N|            n = 0: the ray is parallel to the axis,
;                                  inside everywhere or nowhere, by |(O - B) x
;                                  A|
;   N := N / |N|                   a second length and three divisions
;   d = |(O - B) . N|              distance from axis to ray; d > r: a miss
;   t = -((O - B) x A) . N / n     the closest approach
;   Q = N x A,  Q := Q / |Q|
;   s = |sqrt(r^2 - d^2) / (D . Q)|
;   in = t - s,  out = t + s
;
; Each end is a plane p, q of any direction.  Its inside is p . X + q < 0:
;
;   t = -(p . O + q) / (p . D)
;
; p . D < 0: the ray enters there, and in becomes max(in, t).  p . D > 0: the
; ray leaves there, and out becomes min(out, t).  out < in is a miss.
; |p . D| < tiny: the ray is parallel, inside everywhere or nowhere.
;
;       CALL CLIPPED_CYLINDER (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_CLIPPED_CYLINDER (RAY, PRIMITIVE, SEGMENT)
;
; In:  ox oy oz dx dy dz; the primitive's record.
; Out: tin, tout; a miss is big, minus_big; if there is a crossing, surface_in
;      and surface_out are the surfaces of entry and exit: 0 the side, 1 the
;      bottom, 2 the top.  The scalar form stores them from P_PATCH_POINT on.
; Source: J. M. Cychosz and W. N. Waggenspack, Intersecting a Ray with a
; Cylinder, Graphics Gems IV (1994) 356-365; the program is this project's.

        .reg    across0, shift
        .reg    across1, quad_a
        .reg    across2, quad_b

        .macro  length x0, x1, x2, sum, work
        dot_vectors \x0, \x1, \x2, \x0, \x1, \x2, \sum, \work
        ray_root \sum, \sum
        .endm

        .macro  make_unit x0, x1, x2, sum, work
        .ifdef  CYLINDER_RECIPROCALS
        normalise \x0, \x1, \x2, \sum, \work
        .else
        length  \x0, \x1, \x2, \sum, \work
        ray_quotient \x0, \sum, \x0
        ray_quotient \x1, \sum, \x1
        ray_quotient \x2, \sum, \x2
        .endif
        .endm

; c = the cross product of x and the axis.
        .macro  across_axis x0, x1, x2, c0, c1, c2
        cross_constant \x0, \x1, \x2, sh3, sh4, sh5, \c0, \c1, \c2, t8
        .endm

; Computes tin, tout of the infinite cylinder.  Independent operations run
; during divisions and square roots of the scalar form.
        .macro  find_side miss
        across_axis dx, dy, dz, t0, t1, t2
        three   ray_lower, ox, oy, oz, sh0, sh1, sh2, t4, t5, t6
        length  t0, t1, t2, t3, t8
        across_axis t4, t5, t6, across0, across1, across2
        unless_parallel t3, side_along\@
        make_unit t0, t1, t2, t7, t8
        dot_vectors t4, t5, t6, t0, t1, t2, t7, t8
        set_within t7, sh6, bits1, \miss
        dot_vectors across0, across1, across2, t0, t1, t2, t9, t8
        quotient_opposite t9, t3, across0       ; the closest approach
        across_axis t0, t1, t2, t4, t5, t6
        make_unit t4, t5, t6, t3, t8
        half_chord t7, sh6, bits1
        dot_vectors dx, dy, dz, t4, t5, t6, t3, t8
        ray_quotient t7, t3, t7
        segment_about across0, t7, bits1
        only_parallel side_along\@, side_crossed\@
        restore_across
        length  across0, across1, across2, t3, t8
        inside_if_number_not_less sh6, t3, \miss
side_crossed\@:
        .ifndef CYLINDER_UNRECORDED
        ray_set r0, surface_in
        ray_set r0, surface_out
        .endif
        .endm

        .macro  find_clipped miss
        enter_shape clipped
        find_side \miss
        clip    sh7, sh8, sh9, sh10, one, \miss
        clip    sh11, sh12, sh13, sh14, two, \miss
        .endm

        shape_record clipped, 15, 63
        .kernel cylinder
clipped_cylinder:
        find_clipped clipped_missed
        close_segment
clipped_recorded:
        give_surfaces
        leave_shape
        missed  clipped_missed

        .ifndef CYLINDER_UNRECORDED
open_clipped_cylinder:
        find_clipped clipped_missed
        leave_with_side clipped_missed, clipped_recorded
        .endif
        .endkernel
