; smooth_scalar.s - the adjustment of smooth.s, word by word.

        .include "heat/elimination_scalar.s"

        .reg    smo_flow, r48

        .kernel smooth
smooth:
        smooth_begin

; d = the sum of all columns of v, smo_sum = the sum of all columns of x.
        ES      lin_i, 0
smooth_row:
        RTOR    smo_variances, lin_from
        RTOR    smo_flows, lin_to
        RTOR    lin_n, lin_left
        LOD     [lin_from, lin_i], lin_work0
        LOD     [lin_to, lin_i], lin_work1
smooth_add:
        ADDX    lin_from, lin_stride, lin_from
        ADDX    lin_to, lin_stride, lin_to
        LOD     [lin_from, lin_i], lin_work2
        LOD     [lin_to, lin_i], smo_flow
        ADDN    lin_work0, lin_work2, lin_work0
        ADDN    lin_work1, smo_flow, lin_work1
        IBXNE   lin_left, lin_minus_one, r0, smooth_add, lin_left

; b = (A - smo_sum) / d. A d of 0 is replaced by 1.
        LOD     [smo_areas, lin_i], lin_work2
        SUBN    lin_work2, lin_work1, lin_work1
        CFPNE   lin_work0, r0, smooth_known
        RTOR    smo_unit, lin_work0
smooth_known:
        DIVS    lin_work1, lin_work0, lin_work1
        STO     [smo_d, lin_i], lin_work0
        STO     [lin_b, lin_i], lin_work1
        IBXNE   lin_i, lin_one, lin_n, smooth_row, lin_i

; The matrix is v / d, with 1 in the diagonal.
        RTOR    smo_variances, lin_from
        RTOR    lin_matrix, lin_to
        RTOR    lin_matrix, lin_at
        RTOR    lin_n, lin_left
smooth_column:
        ES      lin_i, 0
smooth_entry:
        LOD     [lin_from, lin_i], lin_work0
        LOD     [smo_d, lin_i], lin_work1
        DIVS    lin_work0, lin_work1, lin_work0
        STO     [lin_to, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_n, smooth_entry, lin_i
        STO     [lin_at], smo_unit
        ADDX    lin_from, lin_stride, lin_from
        ADDX    lin_to, lin_stride, lin_to
        ADDX    lin_at, lin_stride, lin_at
        IX      lin_at, 64
        IBXNE   lin_left, lin_minus_one, r0, smooth_column, lin_left

        eliminate smooth_singular
        solve   smooth_flow

; y = x + v (l + l_j); in the diagonal y = x + v l_j.
smooth_flow:
        RTOR    smo_variances, lin_from
        RTOR    smo_flows, lin_column
        RTOR    smo_results, lin_to
        ES      lin_k, 0
smooth_next:
        LOD     [lin_x, lin_k], lin_pivot
        ES      lin_i, 0
smooth_word:
        LOD     [lin_x, lin_i], lin_work0
        LOD     [lin_from, lin_i], lin_work1
        LOD     [lin_column, lin_i], lin_work2
        ADDN    lin_work0, lin_pivot, lin_work0
        IBXNE   lin_i, r0, lin_k, smooth_both
        RTOR    lin_pivot, lin_work0
smooth_both:
        MPYS    lin_work0, lin_work1, lin_work0
        ADDN    lin_work0, lin_work2, lin_work0
        STO     [lin_to, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_n, smooth_word, lin_i
        ADDX    lin_from, lin_stride, lin_from
        ADDX    lin_column, lin_stride, lin_column
        ADDX    lin_to, lin_stride, lin_to
        IBXNE   lin_k, lin_one, lin_n, smooth_next, lin_k

; Flows to the environment: y = x + v l.
        ES      lin_i, 0
smooth_outer:
        LOD     [lin_x, lin_i], lin_work0
        LOD     [lin_from, lin_i], lin_work1
        LOD     [lin_column, lin_i], lin_work2
        MPYS    lin_work0, lin_work1, lin_work0
        ADDN    lin_work0, lin_work2, lin_work0
        STO     [lin_to, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_n, smooth_outer, lin_i
        smooth_end
        .endkernel
