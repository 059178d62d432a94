; crossed_scalar.s - iterates over crossings one by one, for the scalar forms.

        .regs   r32, col_s, col_normal, col_ray, col_part, col_sign, col_object_depth, col_scene_depth
        .regs   r39, col_w, col_lane, col_lanes_most

; Loads the next crossing, or branches to `none` if none is left.
        .macro  crossed_next none
        IBXEQ   col_left, r0, r0, \none
        RTOR    col_planes, col_work0
        crossed_word col_s
        crossed_word col_normal
        crossed_word col_ray
        crossed_word col_part
        crossed_word col_sign
        crossed_word col_object_depth
        crossed_word col_scene_depth
        .endm

        .macro  crossed_word register
        LOD     [col_work0], \register
        ADDX    col_work0, col_stride, col_work0
        .endm

        .macro  crossed_done again
        IX      col_planes, 64
        SUBX    col_left, col_index_one, col_left
        IBXNE   col_lane, col_index_one, col_lanes_most, \again, col_lane
        ES      col_lane, 0
        BIM     \again
        .endm

        .macro  lanes_begin
        ES      col_lane, 0
        ES      col_lanes_most, LANES
        .endm

; Sets col_w to w, which is -1 where the ray enters by the count `bodies`.
; Branches to `no_crossing` if the ray neither enters nor leaves.
        .macro  find_weight bodies, invisible
        IBXEQ   col_sign, r0, r0, \invisible
        IBXNE   col_sign, r0, col_index_one, weight_leaves\@
        IBXNE   \bodies, r0, col_index_one, \invisible
        RTOR    col_minus_one, col_w
        BIM     weight_found\@
weight_leaves\@:
        IBXNE   \bodies, r0, r0, \invisible
        RTOR    col_one, col_w
weight_found\@:
        .endm

; Folds the lanes of each sum into one.
        .macro  fold_lanes
fold_sum\@:
        ES      col_half_lanes, LANES / 2
fold_halve\@:
        ES      col_lane, 0
        SHIFTI  col_half_lanes, 6, col_work0
        ADDX    col_lanes, col_work0, col_upper
fold_lane\@:
        LOD     [col_lanes, col_lane], col_work0
        LOD     [col_upper, col_lane], col_work1
        ADDN    col_work0, col_work1, col_work0
        STO     [col_lanes, col_lane], col_work0
        IBXNE   col_lane, col_index_one, col_half_lanes, fold_lane\@, col_lane
        SHIFTI  col_half_lanes, -1, col_half_lanes
        IBXNE   col_half_lanes, r0, r0, fold_halve\@
        next_sum fold_sum\@
        .endm
