; segments_scalar.s - segments of a ray in a shape whose crossings are roots.
;
; Boolean trees use them; segments_vector.s describes the order of crossings.

; Like find_lanes, for the whole line.
        .macro  find_all_lanes x0, x1, x2, bound2, miss
        find_bound \x0, \x1, \x2, \bound2, \miss
        SUBN    r0, near_high, near_low
        .endm

; e0 := number of roots; they are stored from e1 on.
        .macro  solve_all resolution
        RTOR    \resolution, near_resolution
        call_quartic solve_quartic_signs
        EX      e1, near_roots
        ES      t3, 4
        LOD     [e1, t3], e0
        .endm

; Stores `words` crossings from a_segment on. e4 = 1: the line begins inside.
        .macro  give_segments words
        ES      e3, \words
        IBXEQ   e4, r0, r0, segments_root\@
        STO     [a_segment], minus_big
        IX      a_segment, 64
        IX      e3, -1
segments_root\@:
        CFPGE   r0, e0, segments_end\@
        LOD     [e1], t3
        IX      e1, 64
        SUBN    e0, one, e0
        SUBN    t3, along, t3
        STO     [a_segment], t3
        IX      a_segment, 64
        IX      e3, -1
        BIM     segments_root\@
segments_end\@:
        AND     e3, index_one, e4
        IBXEQ   e4, r0, r0, segments_even\@
        STO     [a_segment], big
        IX      a_segment, 64
        IX      e3, -1
segments_even\@:
        IBXEQ   e3, r0, r0, segments_stored\@
        STO     [a_segment], big
        STO     [a_segment, index_one], minus_big
        IX      a_segment, 64 * 2
        IX      e3, -2
        BIM     segments_even\@
segments_stored\@:
        .endm

        .macro  leave_segments save=near_save, registers=LANE_REGISTERS
        RTOR    link_kept, link
        leave   \save, \registers
        .endm
