; disc.s - intersects rays with a disc or a ring: the points X of a plane with
; r <= |X - C| <= R.
;
; The crossing t with the plane is that of plane.s.  With L = O - C,
;
;   r^2 <= (L + t D) . (L + t D) <= R^2
;
; In a Boolean tree the inside of a disc is the half space below its plane; the
; kernel of the plane computes that.
;
;       CALL DISC (RAY, PRIMITIVE, SEGMENT)
;
; In:  ox oy oz dx dy dz; the primitive's record.
; Out: tin = tout = t; a miss is big, minus_big.
; Record: unit normal 3, distance, centre 3, squares of the radii of disc and
;         hole.
; Source: textbook; the definition of its inside is POV-Ray's.

        .macro  disc_axis o, d, center, into
        ray_lower \o, \center, \into
        ray_times t2, \d, t3
        ray_plus t3, \into, \into
        .endm

        shape_record disc, 9, 55, tiny          ; after t6
        .kernel disc
disc:
        enter_shape disc, tiny
        intersect_plane disc_missed
        disc_axis ox, dx, sh4, t4
        disc_axis oy, dy, sh5, t5
        disc_axis oz, dz, sh6, t6
        dot_vectors t4, t5, t6, t4, t5, t6, t0, t3
        set_number_not_less sh7, t0, bits1, disc_missed
        keep_not_less_number t0, sh8, bits1, disc_missed, bits2
        remove  bits0, bits1
        point_in bits1, t2
        leave_shape tiny
        missed  disc_missed, tiny
        .endkernel
