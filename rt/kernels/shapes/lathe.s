; lathe.s - intersects rays with a lathe: the segments of a
; path in r and y, r >= 0, turned about the y axis.  Each sweeps a piece of a
; cone.
;
; y = 0 is a height within the path.  o is the ray's closest approach to that
; point of the axis and d its direction.  In r and y a ray is a hyperbola.  A
; corner (r, y) of the path is beyond the hyperbola, seen from the axis, if
;
;   (r dy)^2 > (ox dy - oy dx + y dx)^2 + (oz dy - oy dz + y dz)^2
;
; The region beyond it is convex.  So a segment is crossed
;
;   once            if one of its corners is beyond and the other is not;
;   never           if both are: it is skipped;
;   twice or never  if neither is.  It is also skipped if the ray reaches its
;                   heights only outside the cylinder that bounds the path.
;
; A corner at a height at which the ray is outside that cylinder is not beyond.
; If this is so for all rays of the queue, nothing is computed for the corner,
; and nothing for segments at such heights.
;
; A corner is decided once for both its segments, and a corner on the axis is
; never beyond.  So a ray crosses a path that is closed, or that begins and ends
; on the axis, an even number of times, independently of rounding.
;
; The line of the segment is  nr r + ny y = k,  nr >= 0, nr^2 + ny^2 = 1:
;
;   e = k - ny oy     f = ny dy
;   a = nr^2 (dx^2 + dz^2) - f^2      b = nr^2 (ox dx + oz dz) + e f
;   c = nr^2 (ox^2 + oz^2) - e^2      root = nr sqrt(E)
;   E = (e dx + f ox)^2 + (e dz + f oz)^2 - nr^2 (ox dz - oz dx)^2
;
; The cone is a t^2 + 2 b t + c = 0, with b^2 - a c = nr^2 E.  In E nothing
; large cancels if the line is nearly level.  For either sign of a the ray
; crosses to the axis' side at t = (-b - root)/a and back at (-b + root)/a.
; These are q/a and c/q with q = -(b + sign(b) root) (forms_vector.s).
;
; Once:  the root whose side the corners show, clamped to the heights of the
;        segment.
; Twice: both roots if a > 0, E > 0 and their middle is between the heights, the
;        lower one included:  (low - oy) a <= -b dy < (high - oy) a.
;
; lathe: the nearest crossing ahead.
; lathe_solid: the segments inside the closed path (columns_vector.s).
; open_lathe_crossings: the crossings, in the same columns; the last one is
;   repeated if their number is odd.
;
;       CALL LATHE (RAY, PRIMITIVE, SEGMENT)
;       CALL LATHE_SOLID (RAY, PRIMITIVE, SEGMENTS)
;       CALL OPEN_LATHE_CROSSINGS (RAY, PRIMITIVE, CROSSINGS)
;
; In:  ox oy oz dx dy dz lower; the primitive's record and table.
;      The rows after those of the visible surface close the path
;      (rt/shapes/lathe.c).
; Out: tin = tout = the nearest crossing ahead; a miss is big, minus_big.
;      lathe_solid: P_SEGMENTS segments, in successive vectors from tin on;
;      open_lathe_crossings: P_SEGMENTS pairs of crossings.
; Record: height of its middle, square of its radius, half height, number of
;         visible rows, number of rows, bound of the distance of its points:
;         square, and a slightly greater value.  Table: rows (records.s).
; Source: derived here; the project's notes on ray tracing, 0 and 4.2.

        .if     LATHES
        include_form columns

; o is lane_ox, lane_oy, lane_oz.
        .reg    rise_square, lane_dx            ; dy^2
        .reg    level_square, lane_dy           ; dx^2 + dz^2
        .reg    per_rise, lane_dz               ; 1 / dy
        .reg    level_way, lane_at              ; ox dx + oz dz
        .reg    from_axis, k4                   ; ox^2 + oz^2
        .reg    gap, k2                         ; (ox dz - oz dx)^2
        .reg    turn_x, k1                      ; ox dy - oy dx
        .reg    turn_z, e0                      ; oz dy - oy dz
        .reg    ray_low, lane_low               ; heights within the cylinder
        .reg    ray_high, lane_high
        .reg    line_e, e1                      ; of the segment
        .reg    line_f, e2
        .reg    cone_a, e3
        .reg    cone_b, e4
        .reg    cone_c, e5
        .reg    cone_q, e6
        .reg    beyond, set0
        .reg    beyond_before, set1
        .reg    once, set2
        .reg    twice, set3
        .reg    falling, set4                   ; dy < 0

; The words of a row.
        .reg    row_square, row8
        .reg    row_height, row9
        .reg    row_begins, row10
        .reg    row_low, row11
        .reg    row_high, row12
        .reg    row_rises, row13
        .reg    line_ny, row14
        .reg    line_k, row15
        .reg    line_nr2, row16
        .reg    line_nr, row17
        .reg    segment_at, row3
        .reg    segments_left, row4

; Computes the heights of each ray within the cylinder that bounds the path.
; With h = sqrt(R^2 (dx^2 + dz^2) - (ox dz - oz dx)^2) they are
;   oy - (ox dx + oz dz +- h) dy / (dx^2 + dz^2),
; or all heights for a ray parallel to y.  Branches to miss if no ray is within
; the heights of the path.
        .macro  heights_within miss
        SUBN    r0, sh2, number
        unless_zero level_square, bits1, heights_all\@
        ray_scaled_minus level_square, sh1, gap, t0
        keep_real t0, bits0, \miss
        ray_root t0, t0
        quotient_outside bits1, dy, level_square, t1
        ray_plus level_way, t0, t2
        ray_minus level_way, t0, t3
        ray_times t2, t1, t2
        ray_times t3, t1, t3
        ray_minus lane_oy, t2, t2
        ray_minus lane_oy, t3, t3
        either_two_if_negative dy, falling, t3, t2, ray_low, t2, t3, ray_high
        done    heights_known\@
heights_all\@:
        number_in bits1, number, ray_low
        number_in bits1, sh2, ray_high
heights_known\@:
        none_in bits0, ray_low, ray_high
        range_of_queue ray_low, ray_high
        CFPLT   queue_high, number, \miss
        CFPLT   sh2, queue_low, \miss
        .endm

        .macro  begin_lathe miss
        all_lanes
        ray_lower oy, sh0, t1
        closest_approach ox, t1, oz, lane_ox, lane_oy, lane_oz, lane_along, t3, t4
        ray_times dx, dx, level_square
        ray_times dz, dz, t0
        ray_times lane_ox, dx, level_way
        ray_times lane_oz, dz, t1
        ray_times lane_ox, lane_ox, from_axis
        ray_times lane_oz, lane_oz, t2
        ray_times lane_ox, dz, gap
        ray_times lane_oz, dx, t3
        ray_plus t0, level_square, level_square
        ray_plus t1, level_way, level_way
        ray_plus t2, from_axis, from_axis
        ray_minus gap, t3, gap
        ray_times gap, gap, gap
        note_negative dy, falling
        heights_within \miss
        ray_times dy, dy, rise_square
        ray_times lane_ox, dy, turn_x
        ray_times lane_oy, dx, t0
        ray_times lane_oz, dy, turn_z
        ray_times lane_oy, dz, t1
        ray_minus turn_x, t0, turn_x
        ray_minus turn_z, t1, turn_z
        reciprocal_or_one dy, per_rise
        .endm

; beyond = the row's corner is beyond the hyperbola.
        .macro  find_corner_side
        begin_clear beyond
        CFPLT   row_height, queue_low, corner_far\@
        CFPLT   queue_high, row_height, corner_far\@
        ray_scaled_plus_two dx, row_height, turn_x, t0, dz, row_height, turn_z, t1
        ray_times t0, t0, t0
        ray_times t1, t1, t1
        ray_plus t1, t0, t0
        mark_less_scaled t0, rise_square, row_square, beyond, corner_far\@
        keep_within row_height, ray_low, ray_high, beyond
        end_clear beyond, corner_far\@
        .endm

; Computes the coefficients of the segment's cone, and t0 = E.
        .macro  intersect_cone
        ray_scale dy, line_ny, line_f
        ray_from_scaled line_k, lane_oy, line_ny, line_e
        ray_times line_f, lane_ox, t2
        ray_times line_f, lane_oz, t3
        ray_times line_f, line_f, t4
        ray_times line_e, dx, t0
        ray_times line_e, dz, t1
        ray_plus t2, t0, t0
        ray_times line_e, line_f, t2
        ray_plus t3, t1, t1
        ray_times line_e, line_e, t3
        ray_times t0, t0, t0
        ray_scaled_minus level_square, line_nr2, t4, cone_a
        ray_times t1, t1, t1
        ray_scaled_plus level_way, line_nr2, t2, cone_b
        ray_plus t1, t0, t0
        ray_scaled_minus from_axis, line_nr2, t3, cone_c
        ray_minus_scaled t0, gap, line_nr2, t0
        .endm

; Keeps the rays of twice that cross the segment itself.  Branches to missed if
; no ray crosses it.
        .macro  keep_twice missed
        unless_once once, twice_kept\@
        keep_number_less r0, t0, twice, \missed
        keep_number_less r0, cone_a, twice, \missed
        skip_empty twice, twice_kept\@
        ray_times cone_b, dy, t1
        ray_from_times_two row_low, lane_oy, cone_a, t2, row_high, lane_oy, cone_a, t3
        opposite t1
        keep_opposite_not_less t1, t2, twice, \missed
        keep_opposite_less t1, t3, twice, \missed
twice_kept\@:
        skip_both twice, once, \missed
        .endm

; Computes crossed_at of the rays of once.  If the segment rises, a ray that
; rises goes to the axis' side exactly if its upper corner is beyond.
        .macro  cross_once
        turned_by cone_b, beyond, chosen
        turned_if_negative dy, falling, chosen
        either_two_by row_rises, chosen, cone_c, cone_q, crossed_at, cone_q, cone_a, t1
        ray_if_equal_number t1, r0, once_divided\@
        ray_then_set one, t1
        ray_end_if once_divided\@
        ray_quotient crossed_at, t1, crossed_at
        ray_from_times_two row_low, lane_oy, per_rise, t1, row_high, lane_oy, per_rise, t2
        either_two_if_negative dy, falling, t2, t1, t3, t1, t2, t4
        ray_not_below t3, crossed_at
        ray_not_above t4, crossed_at
        ray_minus crossed_at, lane_along, crossed_at
        .endm

; Computes crossed_at of the rays of twice as over / under.
        .macro  cross_twice over, under
        quotient_in twice, \over, \under, crossed_at
        ray_minus crossed_at, lane_along, crossed_at
        .endm

; Computes the crossings with the first `rows` rows; found uses crossed_at of
; the rays of a set.
        .macro  walk_segments rows, found
        load_field P_TABLE, segment_at
        RTOR    \rows, segments_left
segment\@:
        load_from segment_at, 10, row_square
        IX      segment_at, 64 * LATHE_SIZE
        find_corner_side
        CFPNE   row_begins, r0, segment_passed\@
        CFPLT   row_high, queue_low, segment_passed\@
        CFPLT   queue_high, row_low, segment_passed\@
        exclusive beyond, beyond_before, once
        find_twice once, beyond, beyond_before, twice, segment_passed\@
        intersect_cone
        keep_twice segment_passed\@
        ray_not_below_number r0, t0
        ray_root_scale t0, line_nr, t0
        sum_away cone_b, t0, cone_q, chosen
        if_any  once, segment_twice\@
        cross_once
        \found  once
        done    segment_passed\@
segment_twice\@:
        skip_empty twice, segment_passed\@
        cross_twice cone_q, cone_a
        \found  twice
        cross_twice cone_c, cone_q
        \found  twice
segment_passed\@:
        keep_before beyond, beyond_before
        SUBN    segments_left, one, segments_left
        CFPLT   r0, segments_left, segment\@
        .endm

; tin = the nearest crossing ahead.
        .macro  crossed_ahead bits
        subset_less least, crossed_at, \bits, bits1, crossed_not\@
        keep_less crossed_at, tin, bits1, crossed_not\@
        copy_in bits1, crossed_at, tin
crossed_not\@:
        .endm

        saves   lathe, 86, r76
        .kernel lathe
lathe:
        enter_columns lathe, 5
        begin_lathe lathe_missed
        ray_set big, tin
        walk_segments sh3, crossed_ahead
        leave_at_nearest lathe, lathe_missed
        missed_by_all lathe_missed, lathe

lathe_solid:
        enter_columns lathe, 5
        begin_columns
        begin_lathe lathe_filled
        walk_segments sh4, insert
        BIM     lathe_filled
open_lathe_crossings:
        enter_columns lathe, 5
        begin_columns
        begin_lathe lathe_filled
        walk_segments sh3, insert
lathe_filled:
        leave_columns lathe
        .endkernel
        .endif
