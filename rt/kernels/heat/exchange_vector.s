; exchange_vector.s - the exchange of exchange.s, whole columns at a time.

        .include "heat/exchange.s"

        .regs   r44, v_a, v_b, v_c, v_d, v_e

; exc_left words, 1 or more, at the address become one, there.
        .macro  fold_words address
        BIM     fold_whole\@
fold_halve\@:
        ADDX    exc_left, exc_one, exc_half
        SHIFTI  exc_half, -1, exc_half
        SUBX    exc_left, exc_half, exc_left
        SHIFTI  exc_half, 6, exc_work0
        ADDLEN  \address, exc_left, exc_at
        ADDX    exc_at, exc_work0, exc_upper
        ADDNV   [exc_at], [exc_upper], [exc_at]
        RTOR    exc_half, exc_left
fold_whole\@:
        IBXNE   exc_left, r0, exc_one, fold_halve\@
        .endm

        .entry  exchange
        .kernel exchange
exchange:
        exchange_begin
        ADDLEN  exc_emissivities, exc_n, v_e
        ADDLEN  exc_spare, exc_n, v_d
        ADDLEN  exc_b, exc_n, v_b

; b = e sigma T^4; the spare column: e - 1.
        ADDLEN  exc_temperatures, exc_n, v_a
        MPYSV   [v_a], [v_a], [v_b]
        MPYSV   [v_b], [v_b], [v_b]
        MPYSV   [v_b], exc_sigma, [v_b]
        MPYSV   [v_b], [v_e], [v_b]
        SUBNV   [v_e], exc_unit, [v_d]

; The columns of the matrix, its diagonal.
        ADDLEN  exc_factors, exc_n, v_a
        ADDLEN  exc_matrix, exc_n, v_c
        RTOR    exc_n, exc_left
        RTOR    exc_matrix, exc_at
exchange_column:
        MPYSV   [v_d], [v_a], [v_c]
        LOD     [exc_at], exc_work0
        ADDN    exc_work0, exc_unit, exc_work0
        STO     [exc_at], exc_work0
        ADDX    v_a, exc_stride, v_a
        ADDX    v_c, exc_stride, v_c
        ADDX    exc_at, exc_stride, exc_at
        IX      exc_at, 64
        IBXNE   exc_left, exc_minus_one, r0, exchange_column, exc_left

; What comes from outside, in H for now: b less (e - 1) F_e J_e.
        ADDLEN  exc_h, exc_n, v_c
        MPYSV   [v_a], exc_outside, [v_c]
        ADDLEN  exc_q, exc_n, v_a
        MPYSV   [v_d], [v_c], [v_a]
        SUBNV   [v_b], [v_a], [v_b]

; Elimination below the diagonal at exc_at.
        RTOR    exc_matrix, exc_at
        ES      exc_k, 0
exchange_step:
        LOD     [exc_at], exc_pivot
        CFPLT   exc_pivot, exc_least, exchange_singular
        ADDX    exc_k, exc_one, exc_row
        SUBX    exc_n, exc_row, exc_below
        IBXEQ   exc_below, r0, r0, exchange_solve
        ADDX    exc_at, r0, v_a
        IX      v_a, 64
        ADDLEN  v_a, exc_below, v_a
        DIVSV   [v_a], exc_pivot, [v_a]
        ADDX    exc_at, exc_stride, exc_row     ; A(k, j)
        RTOR    exc_below, exc_left
exchange_next:
        LOD     [exc_row], exc_work0
        SUBN    r0, exc_work0, exc_work0
        ADDX    exc_row, r0, v_c
        IX      v_c, 64
        ADDLEN  v_c, exc_below, v_c
        RTOR    v_c, v_d
        LINKV
        MPYSV   [v_a], exc_work0, [v_d]
        ADDNV   [v_d], [v_c], [v_c]
        ADDX    exc_row, exc_stride, exc_row
        IBXGE   exc_left, exc_minus_one, r0, exchange_next, exc_left
        IX      exc_at, 64
        ADDX    exc_at, exc_stride, exc_at
        IBXNE   exc_k, exc_one, exc_n, exchange_step, exc_k

; From the last on: J_k = b_k / A(k, k), and b less A(1 .., k) J_k above.
exchange_solve:
        RTOR    exc_n, exc_k
        RTOR    exc_b, exc_column
exchange_back:
        SUBX    exc_column, exc_stride, exc_column
        SUBX    exc_k, exc_one, exc_k
        LOD     [exc_column, exc_k], exc_pivot
        LOD     [exc_b, exc_k], exc_work0
        DIVS    exc_work0, exc_pivot, exc_work0
        STO     [exc_j, exc_k], exc_work0
        IBXEQ   exc_k, r0, r0, exchange_flows
        SUBN    r0, exc_work0, exc_work0
        ADDLEN  exc_column, exc_k, v_a
        ADDLEN  exc_b, exc_k, v_b
        RTOR    v_b, v_d
        LINKV
        MPYSV   [v_a], exc_work0, [v_d]
        ADDNV   [v_d], [v_b], [v_b]
        BIM     exchange_back

; H := H + F_j J_j
exchange_flows:
        ADDLEN  exc_h, exc_n, v_b
        ADDLEN  exc_factors, exc_n, v_a
        ES      exc_k, 0
exchange_meets:
        LOD     [exc_j, exc_k], exc_work0
        RTOR    v_b, v_d
        LINKV
        MPYSV   [v_a], exc_work0, [v_d]
        ADDNV   [v_d], [v_b], [v_b]
        ADDX    v_a, exc_stride, v_a
        IBXNE   exc_k, exc_one, exc_n, exchange_meets, exc_k

; Q = A (J - H); of the environment A F_e (J_e - J), in the spare column.
        ADDLEN  exc_j, exc_n, v_c
        ADDLEN  exc_q, exc_n, v_d
        ADDLEN  exc_areas, exc_n, v_e
        SUBNV   [v_c], [v_b], [v_d]
        MPYSV   [v_d], [v_e], [v_d]
        ADDLEN  exc_spare, exc_n, v_b
        SUBNV   exc_outside, [v_c], [v_b]
        MPYSV   [v_b], [v_a], [v_b]
        MPYSV   [v_b], [v_e], [v_b]
        RTOR    exc_n, exc_left
        fold_words exc_spare
        LOD     [exc_spare], exc_work2
        STO     [exc_end], exc_work2
        VTOV    [v_d], [v_b]
        RTOR    exc_n, exc_left
        fold_words exc_spare
        LOD     [exc_spare], exc_work0
        ADDN    exc_work0, exc_work2, exc_work0
        STO     [exc_end, exc_one], exc_work0
        EXIT

exchange_singular:
        ADDX    exc_k, exc_one, exc_k
        IX      exc_end, 128
        STO     [exc_end], exc_k
        EXIT
        .endkernel
