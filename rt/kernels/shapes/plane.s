; plane.s - intersects rays with a half space: all X with N . X <= d.
;
;   t = (d - N . O) / (N . D)
;
; N . D < 0: the ray enters at t, and the segment is (t, big); else it is
; (minus_big, t).  |N . D| < tiny: the ray is parallel, inside everywhere or
; nowhere.
;
;       CALL PLANE (RAY, PRIMITIVE, SEGMENT)
;
; In:  ox oy oz dx dy dz; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Record: unit normal 3, distance.
; Source: textbook; the plane as the half space below its normal is POV-Ray's.

; Computes t0 = d - N . O, t1 = N . D, t2 = t for the plane in sh0-sh3.
        .macro  intersect_plane parallel
        dot_constant ox, oy, oz, sh0, sh1, sh2, t0, t2
        ray_from sh3, t0, t0
        dot_constant dx, dy, dz, sh0, sh1, sh2, t1, t2
        divide_unless_parallel t0, t1, t2, \parallel
        .endm

        shape_record plane, 4, 51, tiny         ; after t2
        .kernel plane
plane:
        enter_shape plane, tiny
        intersect_plane plane_parallel
        leave_on_half_line t1, r0, t2, tiny
        parallel_rays plane_parallel, plane_crossed
        inside_if_not_less_number t0, r0, plane_missed
plane_crossed:
        leave_shape tiny
        missed  plane_missed, tiny
        .endkernel
