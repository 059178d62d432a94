; columns_scalar.s - the sums of columns.s, one crossing after another.

        .include "mass/crossed_scalar.s"

        .regs   r42, col_p, col_q, col_c
        .regs   r45, moment0, moment1, moment2, moment3, moment4, moment5, moment6, moment7, moment8, moment9, moment10
        .regs   r56, col_last

; Computes the terms of the crossing.
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

; Adds the terms to the lane of the part with the number `part`.
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

        .kernel columns
columns:
        columns_begin
        lanes_begin
        RTOR    col_parts, col_last
columns_next:
        crossed_next columns_fold
        LOD     [col_places, col_ray], col_p
        LOD     [col_q_at, col_ray], col_q
        find_weight col_object_depth, columns_within
        find_moments
        add_moments col_part
columns_within:
        find_weight col_scene_depth, columns_added
        find_moments
        add_moments col_last
columns_added:
        crossed_done columns_next

columns_fold:
        fold_lanes
        EXIT
        .endkernel
