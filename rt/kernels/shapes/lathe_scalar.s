; lathe_scalar.s - intersects one ray with a lathe: the segments of a path,
; turned about the y axis.
;
;       CALL LATHE (RAY, PRIMITIVE, SEGMENT)
;       CALL LATHE_SOLID (RAY, PRIMITIVE, SEGMENTS)
;       CALL OPEN_LATHE_CROSSINGS (RAY, PRIMITIVE, CROSSINGS)
;
; The arguments are those of sphere_scalar.s, the method is that of
; lathe_vector.s.  SEGMENTS receives P_SEGMENTS segments of the ray inside the
; closed path.  CROSSINGS receives the crossings with the visible surface, in
; twice as many words: ascending, the last one repeated if their number is odd,
; then misses.

        .if     LATHES
        .ifndef LANE_REGISTERS
        .include "shapes/lanes_scalar.s"
        .endif
        .ifndef LIST_REGISTERS
        .include "shapes/columns_scalar.s"
        .endif

        .share  local
        .regs   r81, row_square, row_height, row_begins, row_low, row_high
        .regs   r86, row_rises, line_ny, line_k, line_nr2, line_nr
        .regs   r91, near_x, near_y, near_z, beyond
        .regs   r97, beyond_before, segments_left
        .regs   r102, rise_square, level_square, per_rise, level_way, from_axis
        .regs   r107, gap, turn_x, turn_z, ray_low, ray_high
        .regs   r112, line_e, line_f, cone_e, cone_a, cone_b, cone_c, cone_q
        .regs   r119, segment_at
        .endshare
        .equ    LATHE_REGISTERS, 88

        .data
lathe_save:     .space LATHE_REGISTERS
        .code

        .macro  swap_heights
        RTOR    ray_low, t0
        RTOR    ray_high, ray_low
        RTOR    t0, ray_high
        .endm

        .macro  heights_within miss
        CFPEQ   level_square, r0, heights_none\@
        MPYS    level_square, sh1, t0
        SUBN    t0, gap, t0
        CFPLT   t0, r0, \miss
        SQRT    t0, t0
        DIVS    dy, level_square, t1
        ADDN    level_way, t0, t2
        SUBN    level_way, t0, t3
        MPYS    t2, t1, t2
        MPYS    t3, t1, t3
        SUBN    near_y, t2, ray_low
        SUBN    near_y, t3, ray_high
        CFPGE   dy, r0, heights_ordered\@
        swap_heights
heights_ordered\@:
        SUBN    r0, sh2, t0
        CFPLT   ray_high, t0, \miss
        CFPLT   sh2, ray_low, \miss
        BIM     heights_end\@
heights_none\@:
        SUBN    r0, sh2, ray_low
        RTOR    sh2, ray_high
heights_end\@:
        .endm

        .macro  enter_lathe miss
        enter_solver 5, lathe_save, LATHE_REGISTERS
        RTOR    lower, least
        SUBN    oy, sh0, t1
        closest_approach ox, t1, oz, near_x, near_y, near_z, along, t3, t4
        MPYS    dx, dx, level_square
        MPYS    dz, dz, t0
        MPYS    near_x, dx, level_way
        MPYS    near_z, dz, t1
        MPYS    near_x, near_x, from_axis
        MPYS    near_z, near_z, t2
        MPYS    near_x, dz, gap
        MPYS    near_z, dx, t3
        ADDN    t0, level_square, level_square
        ADDN    t1, level_way, level_way
        ADDN    t2, from_axis, from_axis
        SUBN    gap, t3, gap
        MPYS    gap, gap, gap
        heights_within \miss
        MPYS    dy, dy, rise_square
        MPYS    near_x, dy, turn_x
        MPYS    near_y, dx, t0
        MPYS    near_z, dy, turn_z
        MPYS    near_y, dz, t1
        SUBN    turn_x, t0, turn_x
        SUBN    turn_z, t1, turn_z
        RTOR    one, per_rise
        CFPEQ   dy, r0, lathe_level\@
        DIVS    one, dy, per_rise
lathe_level\@:
        .endm

        .macro  load_line
        RTOR    segment_at, t0
        IX      t0, 64 * LATHE_RISES
        ELEN    t0, 5
        SWAP    [t0], row_rises, [r0]           ; row_rises .. line_nr
        .endm

; Computes the coefficients of the segment's cone, and cone_e = E.
        .macro  intersect_cone
        MPYS    near_y, line_ny, line_e
        MPYS    dy, line_ny, line_f
        MPYS    level_square, line_nr2, cone_a
        SUBN    line_k, line_e, line_e
        MPYS    level_way, line_nr2, cone_b
        MPYS    line_f, near_x, t1
        MPYS    line_f, near_z, t3
        MPYS    line_e, dx, t0
        MPYS    line_e, dz, t2
        MPYS    from_axis, line_nr2, cone_c
        ADDN    t1, t0, t0
        ADDN    t3, t2, t2
        MPYS    gap, line_nr2, t1
        MPYS    line_f, line_f, t3
        MPYS    line_e, line_f, t4
        MPYS    line_e, line_e, t5
        MPYS    t0, t0, t0
        MPYS    t2, t2, t2
        SUBN    cone_a, t3, cone_a
        ADDN    cone_b, t4, cone_b
        SUBN    cone_c, t5, cone_c
        ADDN    t2, t0, t0
        SUBN    t0, t1, cone_e
        .endm

; Computes q.
        .macro  solve_cone
        SQRT    cone_e, t0
        ABS     cone_b, t1
        MPYS    t0, line_nr, t0
        ADDN    t1, t0, cone_q
        CFPLT   cone_b, r0, cone_solved\@
        SUBN    r0, cone_q, cone_q
cone_solved\@:
        .endm

; Branches to missed if the ray does not cross the segment twice.
        .macro  keep_twice missed
        CFPGE   r0, cone_e, \missed
        CFPGE   r0, cone_a, \missed
        MPYS    cone_b, dy, t1
        SUBN    row_low, near_y, t2
        SUBN    row_high, near_y, t3
        MPYS    t2, cone_a, t2
        MPYS    t3, cone_a, t3
        SUBN    r0, t1, t1
        CFPLT   t1, t2, \missed
        CFPGE   t1, t3, \missed
        .endm

; Computes crossed_at of a segment that is crossed once: c / q if t0 = 1, else
; q / a.
        .macro  cross_once
        RTOR    beyond, t0
        CFPGE   dy, r0, once_rises\@
        XOR     t0, index_one, t0
once_rises\@:
        CFPLT   cone_b, r0, once_sign\@
        XOR     t0, index_one, t0
once_sign\@:
        CFPNE   row_rises, r0, once_direction\@
        XOR     t0, index_one, t0
once_direction\@:
        RTOR    cone_q, t1
        RTOR    cone_a, t2
        IBXEQ   t0, r0, r0, once_chosen\@
        RTOR    cone_c, t1
        RTOR    cone_q, t2
once_chosen\@:
        CFPNE   t2, r0, once_divided\@
        RTOR    one, t2
once_divided\@:
        DIVS    t1, t2, crossed_at
        SUBN    row_low, near_y, t1
        SUBN    row_high, near_y, t2
        MPYS    t1, per_rise, t1
        MPYS    t2, per_rise, t2
        CFPGE   dy, r0, once_ordered\@
        RTOR    t1, t3
        RTOR    t2, t1
        RTOR    t3, t2
once_ordered\@:
        CFPGE   crossed_at, t1, once_above\@
        RTOR    t1, crossed_at
once_above\@:
        CFPGE   t2, crossed_at, once_below\@
        RTOR    t2, crossed_at
once_below\@:
        SUBN    crossed_at, along, crossed_at
        .endm

; Computes the crossings with the first `rows` rows; found uses each crossed_at.
        .macro  walk_segments rows, found
        RTOR    a_primitive, t0
        IX      t0, 64 * P_TABLE
        LOD     [t0], segment_at
        RTOR    \rows, segments_left
segment\@:
        ELEN    segment_at, 5
        SWAP    [segment_at], row_square, [r0]  ; row_square .. row_high
        ES      beyond, 0
        CFPLT   row_height, ray_low, segment_before\@
        CFPLT   ray_high, row_height, segment_before\@
        MPYS    dx, row_height, t0
        MPYS    dz, row_height, t1
        MPYS    rise_square, row_square, t2
        ADDN    t0, turn_x, t0
        ADDN    t1, turn_z, t1
        MPYS    t0, t0, t0
        MPYS    t1, t1, t1
        ADDN    t1, t0, t0
        CFPGE   t0, t2, segment_before\@
        ES      beyond, 1
segment_before\@:
        CFPNE   row_begins, r0, segment_passed\@
        IBXNE   beyond, r0, beyond_before, segment_once\@
        IBXNE   beyond, r0, r0, segment_passed\@
        CFPLT   ray_high, row_low, segment_passed\@
        CFPLT   row_high, ray_low, segment_passed\@
        load_line
        intersect_cone
        keep_twice segment_passed\@
        solve_cone
        DIVS    cone_q, cone_a, crossed_at
        SUBN    crossed_at, along, crossed_at
        \found
        DIVS    cone_c, cone_q, crossed_at
        SUBN    crossed_at, along, crossed_at
        \found
        BIM     segment_passed\@
segment_once\@:
        load_line
        intersect_cone
        CFPGE   cone_e, r0, segment_real\@
        ADDN    r0, r0, cone_e
segment_real\@:
        solve_cone
        cross_once
        \found
segment_passed\@:
        IX      segment_at, 64 * LATHE_SIZE
        RTOR    beyond, beyond_before
        SUBN    segments_left, one, segments_left
        CFPLT   r0, segments_left, segment\@
        .endm

; tin = the nearest crossing ahead.
        .macro  crossed_ahead
        CFPGE   least, crossed_at, crossed_not\@
        CFPGE   crossed_at, tin, crossed_not\@
        RTOR    crossed_at, tin
crossed_not\@:
        .endm

        .kernel lathe
lathe:
        enter_lathe lathe_miss
        RTOR    big, tin
        walk_segments sh3, crossed_ahead
        CFPGE   tin, big, lathe_miss
        RTOR    tin, tout
        leave_solver lathe_save, LATHE_REGISTERS
lathe_miss:
        miss_near lathe_save, LATHE_REGISTERS

lathe_solid:
        enter_lathe lathe_passed
        begin_columns
        walk_segments sh4, insert
        BIM     lathe_fill
open_lathe_crossings:
        enter_lathe lathe_passed
        begin_columns
        walk_segments sh3, insert
        BIM     lathe_fill
lathe_passed:
        begin_columns
lathe_fill:
        leave_list lathe_save, LATHE_REGISTERS
        .endkernel
        .endif
