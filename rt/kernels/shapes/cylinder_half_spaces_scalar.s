; cylinder_half_spaces_scalar.s - cuts one ray at the ends of a cylinder as two
; half spaces.  The method is that of cylinder_half_spaces_vector.s.

; Intersects tin, tout with the half space o + t d <= at: its segment is t2, t3.
        .macro  half_space o, d, at, miss
        SUBN    \at, \o, t0
        RTOR    minus_big, t2
        RTOR    big, t3
        ABS     \d, t1
        CFPLT   t1, tiny, space_parallel\@
        DIVS    t0, \d, t0
        CFPLT   \d, r0, space_enters\@
        RTOR    t0, t3
        BIM     space_merged\@
space_enters\@:
        RTOR    t0, t2
        BIM     space_merged\@
space_parallel\@:
        CFPLT   t0, r0, \miss
space_merged\@:
        CFPGE   tin, t2, space_far\@
        RTOR    t2, tin
space_far\@:
        CFPGE   t3, tout, space_cut\@
        RTOR    t3, tout
space_cut\@:
        CFPLT   tout, tin, \miss
        .endm

        .macro  cut_by_ends miss
        half_space t5, t6, sh13, \miss
        SUBN    r0, t5, t5
        SUBN    r0, t6, t6
        half_space t5, t6, sh13, \miss
        .endm
