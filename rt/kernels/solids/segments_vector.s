; segments_vector.s - segments of rays in a shape whose crossings are roots.
;
; Boolean trees use them. The root solver finds the crossings. The crossings of
; the whole line within the shape's bound, before the start of the ray and after
; it, are alternately in and out. If the line begins inside, the first in is
; minus_big. If it ends inside, the last out is big. Signs decide, so all other
; crossings form pairs.
; Source: derived here; the project's notes on ray tracing, 0 and 4.1.

; Like find_lanes, for the whole line.
        .macro  find_all_lanes x0, x1, x2, bound2, miss
        find_bound \x0, \x1, \x2, \bound2
        SUBNV   r0, [w6], [w5]
        if_none bits0, m, \miss
        .endm

; Finds all roots of each lane's quartic.
        .macro  solve_all low, high, resolution
        solve_quartics solve_quartic_signs, \low, \high, \resolution
        .endm

; [value] = the distance of a crossing at which a ray enters or leaves. Lanes
; whose root_count does not exceed `number`, a number, get no segment.
        .macro  entry_or_none crossing, number, value
        CMPLTV  \number, [root_count], [hits0]
        MASKV   [\crossing], big, [\value] ? [hits0]
        .endm

        .macro  exit_or_none crossing, number, value
        CMPLTV  \number, [root_count], [hits0]
        MASKV   [\crossing], minus_big, [\value] ? [hits0]
        CMPEQV  [root_count], \number, [hits0]
        VTOV    big, [\value] ? [hits0]
        .endm

        .macro  lanes_enter root, number, t
        SUBNV   [\root], [lane_along], [e0]
        entry_or_none e0, \number, e1
        VTOVX   [lane_at], [e1], [\t]
        .endm

        .macro  lanes_leave root, number, t
        SUBNV   [\root], [lane_along], [e0]
        exit_or_none e0, \number, e1
        VTOVX   [lane_at], [e1], [\t]
        .endm

        .macro  no_segments
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        VTOV    big, [tin2]
        VTOV    minus_big, [tout2]
        .endm

; Computes the two segments of each ray.
        .macro  solve_segments resolution
        solve_all lane_low, lane_high, \resolution
        no_segments
        lanes_enter root0, r0, tin
        lanes_leave root1, one, tout
        lanes_enter root2, two, tin2
        ADDN    one, two, s0
        lanes_leave root3, s0, tout2
        .endm
