; prism.s - intersects rays with a prism: closed loops of
; edges in x and z, swept along y from one cap to the other.  A point is inside
; if an odd number of loops surrounds it.
;
; Seen along y a ray is a line.  For each corner P, relative to the origin o,
;
;   side = dx pz - dz px          the side of the line on which it is
;   along_path = dx px + dz pz    its position along the line
;
; An edge from one corner to the next is crossed if exactly one of their sides
; is >= 0.  So a line crosses each loop an even number of times, independently
; of rounding.  The crossing is at
;
;   t = (way0 + (way1 - way0) side0 / (side0 - side1)) / (dx^2 + dz^2)
;
; The planes of the caps cut the ray to low .. high (forms_vector.s).  It is
; inside at low if it crosses an odd number of edges before low.
;
; A ray along y, dx^2 + dz^2 < tiny^2, is replaced by one along x: it is inside
; everywhere if that crosses an odd number of edges before 0, else nowhere.
;
; prism, open_prism: the nearest crossing: the smallest t beyond the lower
;   limit, or a cap, low or high, if the ray is inside there.
; prism_solid, open_prism_sides: all crossings, sorted into columns
;   (columns_vector.s).
;
;       CALL PRISM (RAY, PRIMITIVE, SEGMENT)
;       CALL OPEN_PRISM (RAY, PRIMITIVE, SEGMENT)
;       CALL PRISM_SOLID (RAY, PRIMITIVE, SEGMENTS)
;       CALL OPEN_PRISM_SIDES (RAY, PRIMITIVE, CROSSINGS)
;
; In:  ox oy oz dx dy dz lower; the primitive's record and table,
;      rows of x, z, 1 if a loop begins there, and the data of its normal
;      (normal_prism.s).
; Out: tin = tout = the nearest crossing; a miss is big, minus_big.
;      prism_solid: P_SEGMENTS segments, in successive vectors from tin on;
;      open_prism_sides: the crossings with the sides between the caps, in the
;      same place, ascending; the last one is repeated if their number is odd.
; Record: low, high, number of rows.  Table: rows (records.s).
; Source: textbook (the crossings of a polygon are counted); derived here.

        include_form columns

        .reg    along_path, lane_at
        .reg    along_path_before, lane_ox
        .reg    side, lane_oy
        .reg    side_before, lane_oz
        .reg    inverse, lane_dx
        .reg    path_dx, lane_dy
        .reg    path_dz, lane_dz
        .reg    edge_low, lane_along
        .reg    edge_high, lane_low
        .reg    cap_low, lane_high
        .reg    cap_high, k4
        .reg    inside_low, set0
        .reg    inside_high, set4
        .reg    left, set1
        .reg    left_before, set2
        .reg    crossed, set3
        .reg    row_at, row0
        .reg    here_x, row1
        .reg    here_z, row2
        .reg    begins, row3
        .reg    rows_left, row4

; Computes the part of the ray between the planes of the caps, and the ray's
; path perpendicular to y.
        .macro  begin_prism shape, miss
        enter_columns \shape, 3
        ray_set minus_big, tin
        ray_set big, tout
        slab    oy, dy, sh0, sh1, \miss
        close_segment
        all_lanes
        ray_copy tin, cap_low
        ray_copy tout, cap_high
        ray_times dx, dx, inverse
        ray_times dz, dz, t1
        ray_plus t1, inverse, inverse
        MPYS    tiny, tiny, number
        if_any_less_number inverse, number, bits0, prism_slanted\@
        either_number bits0, one, inverse, inverse
        either_number bits0, one, dx, path_dx
        either_number bits0, r0, dz, path_dz
        set_ahead cap_high, cap_low, bits1, bits0
        either_number bits1, r0, cap_low, edge_low
        either_number bits1, r0, cap_high, edge_high
        BIM     prism_turned\@
prism_slanted\@:
        RTOR    dx, path_dx
        RTOR    dz, path_dz
        RTOR    cap_low, edge_low
        RTOR    cap_high, edge_high
prism_turned\@:
        ray_into one, inverse, inverse
        clear_set inside_low
        clear_set inside_high
        .endm

; Computes side and along_path of a corner.
        .macro  see_corner x, z, note=note_side
        ray_from \x, ox, t0
        ray_from \z, oz, t1
        ray_times path_dx, t1, side
        ray_times path_dz, t0, t2
        ray_times path_dx, t0, along_path
        ray_times path_dz, t1, t3
        ray_minus side, t2, side
        ray_plus t3, along_path, along_path
        \note   side, left
        .endm

; Computes the crossings with the edges; found uses crossed_at of the rays of
; crossed.
        .macro  walk_edges found
        load_field P_TABLE, row_at
        RTOR    sh2, rows_left
prism_row\@:
        load_from row_at, 3, here_x             ; also here_z, begins
        IX      row_at, 64 * PRISM_SIZE
        see_corner here_x, here_z
        CFPNE   begins, r0, prism_next\@
        if_side_changes side, side_before, left, left_before, crossed, prism_next\@
        ray_minus side_before, side, t0
        quotient_in crossed, side_before, t0, crossed_at
        ray_minus along_path, along_path_before, t1
        ray_times t1, crossed_at, crossed_at
        ray_plus along_path_before, crossed_at, crossed_at
        ray_times crossed_at, inverse, crossed_at
        \found
prism_next\@:
        keep_before side, side_before
        keep_before along_path, along_path_before
        keep_set_before left, left_before
        SUBN    rows_left, one, rows_left
        CFPLT   r0, rows_left, prism_row\@
        .endm

; tin = the nearest side ahead.
        .macro  side_ahead
        keep_not_less crossed_at, edge_low, crossed, side_not\@
        keep_not_less edge_high, crossed_at, crossed, side_not\@
        keep_less least, crossed_at, crossed, side_not\@
        keep_less crossed_at, tin, crossed, side_not\@
        copy_in crossed, crossed_at, tin
side_not\@:
        .endm

        .macro  side_or_cap_ahead
        turn_if_less crossed_at, edge_low, crossed, inside_low
        turn_if_less crossed_at, edge_high, crossed, inside_high
        side_ahead
        .endm

        .macro  cap_ahead inside, cap
        in_set  \inside, cap_not\@
        keep_less least, \cap, \inside, cap_not\@
        keep_less \cap, tin, \inside, cap_not\@
        copy_in \inside, \cap, tin
cap_not\@:
        .endm

; Inserts the crossings between the caps.  inside_high: their number is odd.
        .macro  between_caps
        keep_less_or_turn edge_low, crossed_at, crossed, inside_low, between_not\@
        keep_less crossed_at, edge_high, crossed, between_not\@
        turn    crossed, inside_high
        skip_empty crossed, between_not\@
        insert  crossed
between_not\@:
        .endm

        .macro  side_between
        keep_not_less crossed_at, edge_low, crossed, between_not\@
        keep_not_less edge_high, crossed_at, crossed, between_not\@
        skip_empty crossed, between_not\@
        insert  crossed
between_not\@:
        .endm

        .macro  insert_cap inside, cap
        if_any  \inside, cap_none\@
        ray_copy \cap, crossed_at
        insert  \inside
cap_none\@:
        .endm

        .macro  insert_caps
        exclusive inside_low, inside_high, inside_high
        insert_cap inside_low, cap_low
        insert_cap inside_high, cap_high
        .endm

; The routines of a prism: `walk` computes the crossings with the edges.
        .macro  prism_routines name, shape, walk
\name:
        begin_prism \shape, \shape\()_missed
        ray_set big, tin
        \walk   side_or_cap_ahead
        cap_ahead inside_low, cap_low
        cap_ahead inside_high, cap_high
        leave_at_nearest \shape, \shape\()_missed
open_\name:
        begin_prism \shape, \shape\()_missed
        ray_set big, tin
        \walk   side_ahead
        leave_at_nearest \shape, \shape\()_missed
        missed_columns \shape\()_missed, \shape

\name\()_solid:
        begin_prism \shape, \shape\()_passed
        begin_columns
        \walk   between_caps
        insert_caps
        BIM     \shape\()_fill
open_\name\()_sides:
        begin_prism \shape, \shape\()_passed
        begin_columns
        \walk   side_between
        fill_columns \shape, \shape\()_passed, \shape\()_fill
        .endm

        saves   prism, 70, r76
        .kernel prism
        prism_routines prism, prism, walk_edges
        .endkernel
