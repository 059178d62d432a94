; cone.s - intersects rays with a cone or frustum.
;
; The frame is u, v, w (w along the axis) with its origin at the middle of the
; axis.  The side is  u^2 + v^2 = r(w)^2,  r(w) = r0 + k w,  between w = -half
; and half.  o is the ray's closest approach to that middle and d its direction:
;
;   a = du^2 + dv^2 - (k dw)^2
;   b = ou du + ov dv - r(ow) k dw
;   c = ou^2 + ov^2 - r(ow)^2      roots of a t^2 + 2 b t + c
;
; a > 0: the ray is inside the side between the two roots.
; a < 0: it is outside between them.  They lie on the two halves of the double
;   cone; the ray comes from inside one half and goes into the other.  The half
;   with r > 0 is the one after the second root if k dw > 0, else the one before
;   the first.  There is always a root: a negative discriminant is the rounding
;   of a ray through the apex.
; a = 0: it is parallel to a line of the side, and inside after the one root
;   (b < 0) or before it.  Without a root (b = 0: along the axis of equal radii)
;   it is inside everywhere or nowhere.
;
; The slab of its two disks cuts a solid cone, so nothing remains of the other
; half.  An open cone keeps those of its crossings that lie between the disks.
;
;       CALL CONE (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_CONE (RAY, PRIMITIVE, SEGMENT)
;
; In:  ox oy oz dx dy dz; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Record: centre 3, unit axes 9, mean radius, slope, half length, 1/sqrt(1 +
;         slope^2).
; Source: derived here; the project's notes on ray tracing, 4.1 and 4.2.

; Computes tin, tout of the side, and bits0 = the rays that hit it.  Also sets
; o_along and d_along, origin and direction along w, shift, the shift of the
; origin, and quad_a = a.  k_along > 0: a ray with a <= 0 ends inside.
        .macro  cone_side miss
        enter_shape cone
        three   ray_lower, ox, oy, oz, sh0, sh1, sh2, t0, t1, t2
        closest_approach t0, t1, t2, t0, t1, t2, shift, t3, t4
        dot_constants t0, t1, t2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, t7, t8, o_along, t3, t4, t5, t6
        dot_constants dx, dy, dz, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, t0, t1, d_along, t3, t4, t5, t6
        ray_line o_along, sh13, sh12, t2        ; r(ow)
        ray_scale d_along, sh13, k_along
        ray_times t0, t0, quad_a
        ray_times t7, t0, quad_b
        ray_times t1, t1, t0
        ray_times t8, t1, t1
        ray_times t7, t7, t7
        ray_times t8, t8, t8
        ray_plus t0, quad_a, quad_a
        ray_times k_along, k_along, t0
        ray_plus t1, quad_b, quad_b
        ray_times t2, k_along, t1
        ray_times t2, t2, t2
        ray_plus t8, t7, t7
        ray_minus quad_a, t0, quad_a            ; a
        ray_minus quad_b, t1, quad_b            ; b
        ray_minus t7, t2, quad_c                ; c
        discriminant quad_a, quad_b, quad_c, t2, t0
        clear_if_negative t2, quad_a, \miss
        cone_roots \miss
        .endm

        shape_record cone, 15, 65               ; after k_along
        .kernel cone
cone:
        cone_side cone_missed
        keep_number_not_less r0, quad_a, bits0, cone_cut, bits1
        skip_empty bits0, cone_cut              ; outside between the roots
        unless_number_less r0, k_along, bits0, bits2, bits1, cone_goes
        copy_in bits2, tin, tout
        number_in bits2, minus_big, tin
        else_in bits0, bits2, bits1, cone_cut, cone_goes
        copy_in bits2, tout, tin
        number_in bits2, big, tout
cone_cut:
        SUBN    r0, sh14, number
        slab    o_along, d_along, number, sh14, cone_missed
        close_segment
        move_back shift
        leave_shape

open_cone:
        cone_side cone_missed
        keep_between_disks o_along, d_along, sh14, cone_missed
        move_back shift
        leave_shape
        missed  cone_missed
        .endkernel
