; columns_scalar.s - the sums of columns.s, one crossing after another.

        .include "mass/columns.s"

        .regs   r32, col_s, col_normal, col_ray, col_part, col_sense, col_inside, col_within
        .regs   r39, col_p, col_q, col_w, col_c
        .regs   r43, moment0, moment1, moment2, moment3, moment4, moment5, moment6, moment7, moment8, moment9, moment10
        .regs   r54, col_at, col_lane, col_lanes_most, col_upper, col_count, col_last

; The next word of the crossing.
        .macro  crossed_word register
        LOD     [col_work0], \register
        ADDX    col_work0, col_stride, col_work0
        .endm

; col_w := w, by how many bodies the ray is in; else on at the label.
        .macro  find_weight bodies, unseen
        IBXEQ   col_sense, r0, r0, \unseen
        IBXNE   col_sense, r0, col_index_one, weight_leaves\@
        IBXNE   \bodies, r0, col_index_one, \unseen
        RTOR    col_minus_one, col_w
        BIM     weight_found\@
weight_leaves\@:
        IBXNE   \bodies, r0, r0, \unseen
        RTOR    col_one, col_w
weight_found\@:
        .endm

; What the crossing adds.
        .macro  find_moments
        MPYS    col_w, col_s, moment0
        ABS     col_normal, moment10
        MPYS    moment0, col_p, moment1
        MPYS    moment0, col_q, moment2
        MPYS    moment0, col_s, col_c
        MPYS    moment1, col_p, moment4
        MPYS    moment2, col_q, moment5
        MPYS    col_c, col_half, moment3
        MPYS    col_c, col_s, moment6
        MPYS    moment1, col_q, moment7
        MPYS    moment3, col_p, moment8
        MPYS    moment3, col_q, moment9
        MPYS    moment6, col_third, moment6
        .endm

; .. to the lane of the part of that number.
        .macro  add_moments part
        ES      col_at, 64 * MOMENT_SIZE
        MPYX    \part, col_at, col_at
        EX      col_work0, LANES
        MPYX    col_at, col_work0, col_at
        ADDX    col_lanes, col_at, col_at
        .rept   MOMENT_SIZE
        LOD     [col_at, col_lane], col_work0
        ADDN    col_work0, moment\+, col_work0
        STO     [col_at, col_lane], col_work0
        IX      col_at, 64 * LANES
        .endr
        .endm

        .entry  columns
        .kernel columns
columns:
        columns_begin
        ES      col_lane, 0
        ES      col_lanes_most, LANES
        RTOR    col_parts, col_last
columns_next:
        IBXEQ   col_left, r0, r0, columns_fold
        RTOR    col_planes, col_work0
        crossed_word col_s
        crossed_word col_normal
        crossed_word col_ray
        crossed_word col_part
        crossed_word col_sense
        crossed_word col_inside
        crossed_word col_within
        LOD     [col_places, col_ray], col_p
        LOD     [col_q_at, col_ray], col_q
        find_weight col_inside, columns_within
        find_moments
        add_moments col_part
columns_within:
        find_weight col_within, columns_added
        find_moments
        add_moments col_last
columns_added:
        IX      col_planes, 64
        SUBX    col_left, col_index_one, col_left
        IBXNE   col_lane, col_index_one, col_lanes_most, columns_next, col_lane
        ES      col_lane, 0
        BIM     columns_next

; The lanes of each sum become one.
columns_fold:
        ES      col_half_lanes, LANES / 2
columns_halve:
        ES      col_lane, 0
        SHIFTI  col_half_lanes, 6, col_work0
        ADDX    col_lanes, col_work0, col_upper
columns_lane:
        LOD     [col_lanes, col_lane], col_work0
        LOD     [col_upper, col_lane], col_work1
        ADDN    col_work0, col_work1, col_work0
        STO     [col_lanes, col_lane], col_work0
        IBXNE   col_lane, col_index_one, col_half_lanes, columns_lane, col_lane
        SHIFTI  col_half_lanes, -1, col_half_lanes
        IBXNE   col_half_lanes, r0, r0, columns_halve
        next_sum columns_fold
        EXIT
        .endkernel
