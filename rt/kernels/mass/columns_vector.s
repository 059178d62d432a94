; columns_vector.s - the sums of columns.s, LANES crossings at a time.

        .include "mass/crossed_vector.s"

        .regs   r46, v_p, v_q, v_c
        .regs   r49, moment0, moment1, moment2, moment3, moment4, moment5, moment6, moment7, moment8, moment9, moment10
        .regs   r60, col_part

        .data
        .align  64
column_store:   .space LANES * (MOMENT_SIZE + 3)
        .code

        .macro  column_vector vector, number
        EX      \vector, column_store + 64 * LANES * (\number)
        ADDLEN  \vector, col_n, \vector
        .endm

; Computes the terms of each crossing.
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

; Adds the terms of the crossings in [b_part] to the lanes of the part at
; col_at, and advances col_at to the next part.
        .macro  add_moments
        .rept   MOMENT_SIZE
        ADDLEN  col_at, col_n, col_work0
        ADDNV   [col_work0], [moment\+], [col_work0] ? [b_part]
        IX      col_at, 64 * LANES
        .endr
        .endm

        .kernel columns
columns:
        columns_begin
columns_next:
        crossed_next columns_fold
        column_vector v_p, MOMENT_SIZE
        column_vector v_q, MOMENT_SIZE + 1
        column_vector v_c, MOMENT_SIZE + 2
        .rept   MOMENT_SIZE
        column_vector moment\+, \+
        .endr
        VXTOV   [v_ray], [col_places], [v_p]
        VXTOV   [v_ray], [col_q_at], [v_q]
        find_visible v_object_depth
        find_weights
        find_moments
        RTOR    col_lanes, col_at
        ES      col_part, 0
columns_part:
        CMPEQV  [v_part], col_part, [b_part]
        ANDB    [b_part], [b_visible], [b_part]
        CNTOB   [b_part], col_count
        IBXNE   col_count, r0, r0, columns_add
        IX      col_at, 64 * LANES * MOMENT_SIZE
        BIM     columns_added
columns_add:
        add_moments
columns_added:
        IBXNE   col_part, col_index_one, col_parts, columns_part, col_part
        find_visible v_scene_depth
        find_weights
        find_moments
        RTOR    b_visible, b_part
        add_moments
        crossed_done columns_next

columns_fold:
        fold_lanes
        EXIT
        .endkernel
