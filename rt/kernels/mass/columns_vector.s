; columns_vector.s - the sums of columns.s, LANES crossings at a time.

        .include "mass/columns.s"

        .regs   r32, v_s, v_normal, v_ray, v_part, v_sense, v_inside, v_within
        .regs   r39, v_p, v_q, v_w, v_c
        .regs   r43, moment0, moment1, moment2, moment3, moment4, moment5, moment6, moment7, moment8, moment9, moment10
        .regs   r54, b_enter, b_leave, b_seen, b_part
        .regs   r58, col_n, col_part, col_at, col_count, col_upper
        .regs   r63, col_link, col_target

        .data
        .align  64
column_store:   .space LANES * (MOMENT_SIZE + 4)
column_bits:    .space LANES / 64 * 4 + 4
        .code

        .macro  column_vector vector, number
        EX      \vector, column_store + 64 * LANES * (\number)
        ADDLEN  \vector, col_n, \vector
        .endm

        .macro  column_bit bits, number
        EX      \bits, column_bits + LANES * (\number)
        ADDLEN  \bits, col_n, \bits
        .endm

; The next plane of crossings.
        .macro  crossed_plane vector
        ADDLEN  col_work0, col_n, \vector
        ADDX    col_work0, col_stride, col_work0
        .endm

; [v_w] := w of the crossings in [b_seen], by how many bodies the ray is in.
        .macro  find_weights bodies
        CMPEQV  [v_sense], col_index_one, [b_enter]
        CMPEQV  [\bodies], col_index_one, [b_part]
        ANDB    [b_enter], [b_part], [b_enter]
        CMPEQV  [v_sense], col_index_minus_one, [b_leave]
        CMPEQV  [\bodies], r0, [b_part]
        ANDB    [b_leave], [b_part], [b_leave]
        ORB     [b_enter], [b_leave], [b_seen]
        VTOV    col_one, [v_w]
        VTOV    col_minus_one, [v_w] ? [b_enter]
        .endm

; What each crossing adds.
        .macro  find_moments
        MPYSV   [v_w], [v_s], [moment0]
        MPYSV   [moment0], [v_p], [moment1]
        MPYSV   [moment0], [v_q], [moment2]
        MPYSV   [moment0], [v_s], [v_c]
        MPYSV   [v_c], col_half, [moment3]
        MPYSV   [moment1], [v_p], [moment4]
        MPYSV   [moment2], [v_q], [moment5]
        MPYSV   [v_c], [v_s], [moment6]
        MPYSV   [moment6], col_third, [moment6]
        MPYSV   [moment1], [v_q], [moment7]
        MPYSV   [moment3], [v_p], [moment8]
        MPYSV   [moment3], [v_q], [moment9]
        ABSV    [v_normal], [moment10]
        .endm

; Those in [b_part] to the lanes of the part at col_at, which becomes the next one.
        .macro  add_moments
        .rept   MOMENT_SIZE
        ADDLEN  col_at, col_n, col_work0
        ADDNV   [col_work0], [moment\+], [col_work0] ? [b_part]
        IX      col_at, 64 * LANES
        .endr
        .endm

        .entry  columns
        .kernel columns
columns:
        columns_begin
columns_next:
        IBXEQ   col_left, r0, r0, columns_fold
        ES      col_n, LANES
        IBXLE   col_n, r0, col_left, columns_full
        RTOR    col_left, col_n
columns_full:
        RTOR    col_planes, col_work0
        crossed_plane v_s
        crossed_plane v_normal
        crossed_plane v_ray
        crossed_plane v_part
        crossed_plane v_sense
        crossed_plane v_inside
        crossed_plane v_within
        column_vector v_p, MOMENT_SIZE
        column_vector v_q, MOMENT_SIZE + 1
        column_vector v_w, MOMENT_SIZE + 2
        column_vector v_c, MOMENT_SIZE + 3
        .rept   MOMENT_SIZE
        column_vector moment\+, \+
        .endr
        column_bit b_enter, 0
        column_bit b_leave, 1
        column_bit b_seen, 2
        column_bit b_part, 3
        VXTOV   [v_ray], [col_places], [v_p]
        VXTOV   [v_ray], [col_q_at], [v_q]
        find_weights v_inside
        find_moments
        RTOR    col_lanes, col_at
        ES      col_part, 0
columns_part:
        CMPEQV  [v_part], col_part, [b_part]
        ANDB    [b_part], [b_seen], [b_part]
        CNTOB   [b_part], col_count
        IBXNE   col_count, r0, r0, columns_add
        IX      col_at, 64 * LANES * MOMENT_SIZE
        BIM     columns_added
columns_add:
        add_moments
columns_added:
        IBXNE   col_part, col_index_one, col_parts, columns_part, col_part
        find_weights v_within
        find_moments
        RTOR    b_seen, b_part
        add_moments
        SHIFTI  col_n, 6, col_work0
        ADDX    col_planes, col_work0, col_planes
        SUBX    col_left, col_n, col_left
        BIM     columns_next

; The lanes of each sum become one.
columns_fold:
        ES      col_half_lanes, LANES / 2
        ADDLEN  col_lanes, col_half_lanes, col_at
columns_halve:
        SHIFTI  col_half_lanes, 6, col_work0
        ADDX    col_at, col_work0, col_upper
        ADDNV   [col_at], [col_upper], [col_at]
        SHIFTI  col_half_lanes, -1, col_half_lanes
        RTOR    col_lanes, col_at
        ADDLEN  col_at, col_half_lanes, col_at
        IBXNE   col_half_lanes, r0, r0, columns_halve
        next_sum columns_fold
        EXIT
        .endkernel
