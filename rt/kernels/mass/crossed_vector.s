; crossed_vector.s - iterates over LANES crossings at a time, in vector form.

        .regs   r32, v_s, v_normal, v_ray, v_part, v_sign, v_object_depth, v_scene_depth
        .regs   r39, b_enter, b_leave, b_visible, b_part
        .regs   r43, v_w, col_n, col_count

        .data
        .align  64
crossed_store:  .space LANES
crossed_bits:   .space LANES / 64 * 4 + 4
        .code

        .macro  crossed_bit bits, number
        EX      \bits, crossed_bits + LANES * (\number)
        ADDLEN  \bits, col_n, \bits
        .endm

; Makes a descriptor of the next plane of crossings.
        .macro  crossed_plane vector
        ADDLEN  col_work0, col_n, \vector
        ADDX    col_work0, col_stride, col_work0
        .endm

; Makes descriptors of the next crossings, up to LANES, or branches to `none` if
; none is left.
        .macro  crossed_next none
        IBXEQ   col_left, r0, r0, \none
        ES      col_n, LANES
        IBXLE   col_n, r0, col_left, crossed_full\@
        RTOR    col_left, col_n
crossed_full\@:
        RTOR    col_planes, col_work0
        crossed_plane v_s
        crossed_plane v_normal
        crossed_plane v_ray
        crossed_plane v_part
        crossed_plane v_sign
        crossed_plane v_object_depth
        crossed_plane v_scene_depth
        EX      v_w, crossed_store
        ADDLEN  v_w, col_n, v_w
        crossed_bit b_enter, 0
        crossed_bit b_leave, 1
        crossed_bit b_visible, 2
        crossed_bit b_part, 3
        .endm

        .macro  crossed_done again
        SHIFTI  col_n, 6, col_work0
        ADDX    col_planes, col_work0, col_planes
        SUBX    col_left, col_n, col_left
        BIM     \again
        .endm

; Marks the crossings where the ray enters, where it leaves, and both, by the
; count `bodies`.
        .macro  find_visible bodies
        CMPEQV  [v_sign], col_index_one, [b_enter]
        CMPEQV  [\bodies], col_index_one, [b_part]
        ANDB    [b_enter], [b_part], [b_enter]
        CMPEQV  [v_sign], col_index_minus_one, [b_leave]
        CMPEQV  [\bodies], r0, [b_part]
        ANDB    [b_leave], [b_part], [b_leave]
        ORB     [b_enter], [b_leave], [b_visible]
        .endm

; [v_w] := w, which is -1 at crossings in [b_enter].
        .macro  find_weights
        VTOV    col_one, [v_w]
        VTOV    col_minus_one, [v_w] ? [b_enter]
        .endm

; Folds the lanes of each sum into one.
        .macro  fold_lanes
fold_sum\@:
        ES      col_half_lanes, LANES / 2
        ADDLEN  col_lanes, col_half_lanes, col_at
fold_halve\@:
        SHIFTI  col_half_lanes, 6, col_work0
        ADDX    col_at, col_work0, col_upper
        ADDNV   [col_at], [col_upper], [col_at]
        SHIFTI  col_half_lanes, -1, col_half_lanes
        RTOR    col_lanes, col_at
        ADDLEN  col_at, col_half_lanes, col_at
        IBXNE   col_half_lanes, r0, r0, fold_halve\@
        next_sum fold_sum\@
        .endm
