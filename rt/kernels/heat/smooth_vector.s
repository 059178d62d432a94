; smooth_vector.s - the adjustment of smooth.s, by whole columns.

        .include "heat/elimination_vector.s"

        .reg    smo_bits, r49

        .data
smooth_bits:    .space 1 + 4096 / 64
        .code

        .kernel smooth
smooth:
        smooth_begin

; d = the sum of all columns of v, smo_sum = the sum of all columns of x.
        ADDLEN  smo_d, lin_n, v_d
        ADDLEN  smo_sum, lin_n, v_e
        ADDLEN  smo_variances, lin_n, v_a
        ADDLEN  smo_flows, lin_n, v_b
        VTOV    [v_a], [v_d]
        VTOV    [v_b], [v_e]
        RTOR    lin_n, lin_left
smooth_add:
        ADDX    v_a, lin_stride, v_a
        ADDX    v_b, lin_stride, v_b
        ADDNV   [v_d], [v_a], [v_d]
        ADDNV   [v_e], [v_b], [v_e]
        IBXNE   lin_left, lin_minus_one, r0, smooth_add, lin_left

; b = (A - smo_sum) / d. A d of 0 is replaced by 1.
        EX      smo_bits, smooth_bits
        ADDLEN  smo_bits, lin_n, smo_bits
        ADDLEN  smo_areas, lin_n, v_a
        ADDLEN  lin_b, lin_n, v_b
        SUBNV   [v_a], [v_e], [v_e]
        CMPEQV  [v_d], r0, [smo_bits]
        VTOV    smo_unit, [v_d] ? [smo_bits]
        DIVSV   [v_e], [v_d], [v_b]

; The matrix is v / d, with 1 in the diagonal.
        ADDLEN  smo_variances, lin_n, v_a
        ADDLEN  lin_matrix, lin_n, v_c
        RTOR    lin_matrix, lin_at
        RTOR    lin_n, lin_left
smooth_column:
        DIVSV   [v_a], [v_d], [v_c]
        STO     [lin_at], smo_unit
        ADDX    v_a, lin_stride, v_a
        ADDX    v_c, lin_stride, v_c
        ADDX    lin_at, lin_stride, lin_at
        IX      lin_at, 64
        IBXNE   lin_left, lin_minus_one, r0, smooth_column, lin_left

        eliminate smooth_singular
        solve   smooth_flow

; y = x + v (l + l_j); in the diagonal y = x + v l_j.
smooth_flow:
        ADDLEN  smo_variances, lin_n, v_a
        ADDLEN  smo_flows, lin_n, v_b
        ADDLEN  smo_results, lin_n, v_c
        ADDLEN  lin_x, lin_n, v_e
        ES      lin_k, 0
smooth_next:
        LOD     [lin_x, lin_k], lin_pivot
        ADDNV   [v_e], lin_pivot, [v_c]
        STO     [v_c, lin_k], lin_pivot
        MPYSV   [v_c], [v_a], [v_c]
        ADDNV   [v_c], [v_b], [v_c]
        ADDX    v_a, lin_stride, v_a
        ADDX    v_b, lin_stride, v_b
        ADDX    v_c, lin_stride, v_c
        IBXNE   lin_k, lin_one, lin_n, smooth_next, lin_k

; Flows to the environment: y = x + v l.
        MPYSV   [v_e], [v_a], [v_c]
        ADDNV   [v_c], [v_b], [v_c]
        smooth_end
        .endkernel
