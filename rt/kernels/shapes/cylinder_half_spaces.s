; cylinder_half_spaces.s - cuts rays at the ends of a cylinder as two half
; spaces.
;
; This is one of the formulations that were tried for Table 1 (docs/table1.md).
; The side is computed as in cylinder_vector.s.  Each end is a half space, whose
; segment of the ray is computed as in plane.s.  The result is the maximum of
; the entries and the minimum of the exits.

; Intersects tin, tout with the half space o + t d <= at.
        .macro  half_space o, d, at, miss=
        ray_from \at, \o, t0
        half_space_segment t0, \d, t3, t4, \miss
        ray_not_below t3, tin
        ray_not_above t4, tout
        leave_empty \miss
        .endm

        .macro  cut_by_ends miss=
        half_space t5, t6, sh13, \miss
        ray_from r0, t5, t5
        ray_from r0, t6, t6
        half_space t5, t6, sh13, \miss
        .endm
