; exchange_scalar.s - the exchange of exchange.s, word by word.

        .include "heat/exchange.s"

        .regs   r44, exc_from, exc_to, exc_count, exc_i

; exc_left words, 1 or more, at the address become one, there.
        .macro  fold_words address
        BIM     fold_whole\@
fold_halve\@:
        ADDX    exc_left, exc_one, exc_half
        SHIFTI  exc_half, -1, exc_half
        SUBX    exc_left, exc_half, exc_left
        SHIFTI  exc_half, 6, exc_work0
        ADDX    \address, exc_work0, exc_upper
        ES      exc_i, 0
fold_next\@:
        LOD     [\address, exc_i], exc_work0
        LOD     [exc_upper, exc_i], exc_work1
        ADDN    exc_work0, exc_work1, exc_work0
        STO     [\address, exc_i], exc_work0
        IBXNE   exc_i, exc_one, exc_left, fold_next\@, exc_i
        RTOR    exc_half, exc_left
fold_whole\@:
        IBXNE   exc_left, r0, exc_one, fold_halve\@
        .endm

; exc_count words at exc_to, 1 or more: the words at exc_from times the factor are added.
        .macro  add_times factor
        ES      exc_i, 0
add_next\@:
        LOD     [exc_from, exc_i], exc_work1
        LOD     [exc_to, exc_i], exc_work2
        MPYS    exc_work1, \factor, exc_work1
        ADDN    exc_work1, exc_work2, exc_work1
        STO     [exc_to, exc_i], exc_work1
        IBXNE   exc_i, exc_one, exc_count, add_next\@, exc_i
        .endm

        .entry  exchange
        .kernel exchange
exchange:
        exchange_begin

; b = e sigma T^4; the spare column: e - 1.
        ES      exc_i, 0
exchange_right:
        LOD     [exc_temperatures, exc_i], exc_work0
        LOD     [exc_emissivities, exc_i], exc_work1
        MPYS    exc_work0, exc_work0, exc_work0
        MPYS    exc_work0, exc_work0, exc_work0
        MPYS    exc_work0, exc_sigma, exc_work0
        MPYS    exc_work0, exc_work1, exc_work0
        SUBN    exc_work1, exc_unit, exc_work1
        STO     [exc_b, exc_i], exc_work0
        STO     [exc_spare, exc_i], exc_work1
        IBXNE   exc_i, exc_one, exc_n, exchange_right, exc_i

; The columns of the matrix, its diagonal.
        RTOR    exc_factors, exc_from
        RTOR    exc_matrix, exc_to
        RTOR    exc_n, exc_left
        RTOR    exc_matrix, exc_at
exchange_column:
        ES      exc_i, 0
exchange_entry:
        LOD     [exc_spare, exc_i], exc_work0
        LOD     [exc_from, exc_i], exc_work1
        MPYS    exc_work0, exc_work1, exc_work0
        STO     [exc_to, exc_i], exc_work0
        IBXNE   exc_i, exc_one, exc_n, exchange_entry, exc_i
        LOD     [exc_at], exc_work0
        ADDN    exc_work0, exc_unit, exc_work0
        STO     [exc_at], exc_work0
        ADDX    exc_from, exc_stride, exc_from
        ADDX    exc_to, exc_stride, exc_to
        ADDX    exc_at, exc_stride, exc_at
        IX      exc_at, 64
        IBXNE   exc_left, exc_minus_one, r0, exchange_column, exc_left

; What comes from outside, in H for now: b less (e - 1) F_e J_e.
        ES      exc_i, 0
exchange_outer:
        LOD     [exc_from, exc_i], exc_work0
        LOD     [exc_spare, exc_i], exc_work1
        LOD     [exc_b, exc_i], exc_work2
        MPYS    exc_work0, exc_outside, exc_work0
        STO     [exc_h, exc_i], exc_work0
        MPYS    exc_work1, exc_work0, exc_work1
        SUBN    exc_work2, exc_work1, exc_work2
        STO     [exc_b, exc_i], exc_work2
        IBXNE   exc_i, exc_one, exc_n, exchange_outer, exc_i

; Elimination below the diagonal at exc_at.
        RTOR    exc_matrix, exc_at
        ES      exc_k, 0
exchange_step:
        LOD     [exc_at], exc_pivot
        CFPLT   exc_pivot, exc_least, exchange_singular
        ADDX    exc_k, exc_one, exc_row
        SUBX    exc_n, exc_row, exc_count
        IBXEQ   exc_count, r0, r0, exchange_solve
        RTOR    exc_at, exc_from
        IX      exc_from, 64
        ES      exc_i, 0
exchange_divide:
        LOD     [exc_from, exc_i], exc_work0
        DIVS    exc_work0, exc_pivot, exc_work0
        STO     [exc_from, exc_i], exc_work0
        IBXNE   exc_i, exc_one, exc_count, exchange_divide, exc_i
        ADDX    exc_at, exc_stride, exc_row     ; A(k, j)
        RTOR    exc_count, exc_left
exchange_next:
        LOD     [exc_row], exc_work0
        SUBN    r0, exc_work0, exc_work0
        RTOR    exc_row, exc_to
        IX      exc_to, 64
        add_times exc_work0
        ADDX    exc_row, exc_stride, exc_row
        IBXGE   exc_left, exc_minus_one, r0, exchange_next, exc_left
        IX      exc_at, 64
        ADDX    exc_at, exc_stride, exc_at
        IBXNE   exc_k, exc_one, exc_n, exchange_step, exc_k

; From the last on: J_k = b_k / A(k, k), and b less A(1 .., k) J_k above.
exchange_solve:
        RTOR    exc_n, exc_k
        RTOR    exc_b, exc_column
        RTOR    exc_b, exc_to
exchange_back:
        SUBX    exc_column, exc_stride, exc_column
        SUBX    exc_k, exc_one, exc_k
        LOD     [exc_column, exc_k], exc_pivot
        LOD     [exc_b, exc_k], exc_work0
        DIVS    exc_work0, exc_pivot, exc_work0
        STO     [exc_j, exc_k], exc_work0
        IBXEQ   exc_k, r0, r0, exchange_flows
        SUBN    r0, exc_work0, exc_work0
        RTOR    exc_column, exc_from
        RTOR    exc_k, exc_count
        add_times exc_work0
        BIM     exchange_back

; H := H + F_j J_j
exchange_flows:
        RTOR    exc_factors, exc_from
        RTOR    exc_h, exc_to
        RTOR    exc_n, exc_count
        ES      exc_k, 0
exchange_meets:
        LOD     [exc_j, exc_k], exc_work0
        add_times exc_work0
        ADDX    exc_from, exc_stride, exc_from
        IBXNE   exc_k, exc_one, exc_n, exchange_meets, exc_k

; Q = A (J - H); of the environment A F_e (J_e - J), in the spare column.
        ES      exc_i, 0
exchange_net:
        LOD     [exc_j, exc_i], exc_work0
        LOD     [exc_h, exc_i], exc_work1
        LOD     [exc_areas, exc_i], exc_work2
        SUBN    exc_work0, exc_work1, exc_work1
        MPYS    exc_work1, exc_work2, exc_work1
        STO     [exc_q, exc_i], exc_work1
        LOD     [exc_from, exc_i], exc_work1
        SUBN    exc_outside, exc_work0, exc_work0
        MPYS    exc_work0, exc_work1, exc_work0
        MPYS    exc_work0, exc_work2, exc_work0
        STO     [exc_spare, exc_i], exc_work0
        IBXNE   exc_i, exc_one, exc_n, exchange_net, exc_i
        RTOR    exc_n, exc_left
        fold_words exc_spare
        LOD     [exc_spare], exc_work2
        STO     [exc_end], exc_work2
        ES      exc_i, 0
exchange_copy:
        LOD     [exc_q, exc_i], exc_work0
        STO     [exc_spare, exc_i], exc_work0
        IBXNE   exc_i, exc_one, exc_n, exchange_copy, exc_i
        RTOR    exc_n, exc_left
        fold_words exc_spare
        LOD     [exc_spare], exc_work0
        LOD     [exc_end], exc_work2
        ADDN    exc_work0, exc_work2, exc_work0
        STO     [exc_end, exc_one], exc_work0
        EXIT

exchange_singular:
        ADDX    exc_k, exc_one, exc_k
        IX      exc_end, 128
        STO     [exc_end], exc_k
        EXIT
        .endkernel
