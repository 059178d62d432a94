; exchange_scalar.s - the exchange of exchange.s, word by word.

        .include "heat/elimination_scalar.s"

; Replaces lin_left words at the address, at least one, by their sum.
        .macro  fold_words address
        BIM     fold_whole\@
fold_halve\@:
        ADDX    lin_left, lin_one, lin_half
        SHIFTI  lin_half, -1, lin_half
        SUBX    lin_left, lin_half, lin_left
        SHIFTI  lin_half, 6, lin_work0
        ADDX    \address, lin_work0, lin_upper
        ES      lin_i, 0
fold_next\@:
        LOD     [\address, lin_i], lin_work0
        LOD     [lin_upper, lin_i], lin_work1
        ADDN    lin_work0, lin_work1, lin_work0
        STO     [\address, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_left, fold_next\@, lin_i
        RTOR    lin_half, lin_left
fold_whole\@:
        IBXNE   lin_left, r0, lin_one, fold_halve\@
        .endm

        .kernel exchange
exchange:
        exchange_begin

; b = e sigma T^4; the spare column: e - 1.
        ES      lin_i, 0
exchange_right:
        LOD     [exc_temperatures, lin_i], lin_work0
        LOD     [exc_emissivities, lin_i], lin_work1
        MPYS    lin_work0, lin_work0, lin_work0
        MPYS    lin_work0, lin_work0, lin_work0
        MPYS    lin_work0, exc_sigma, lin_work0
        MPYS    lin_work0, lin_work1, lin_work0
        SUBN    lin_work1, exc_unit, lin_work1
        STO     [lin_b, lin_i], lin_work0
        STO     [exc_spare, lin_i], lin_work1
        IBXNE   lin_i, lin_one, lin_n, exchange_right, lin_i

; Computes the columns of the matrix and its diagonal.
        RTOR    exc_factors, lin_from
        RTOR    lin_matrix, lin_to
        RTOR    lin_n, lin_left
        RTOR    lin_matrix, lin_at
exchange_column:
        ES      lin_i, 0
exchange_entry:
        LOD     [exc_spare, lin_i], lin_work0
        LOD     [lin_from, lin_i], lin_work1
        MPYS    lin_work0, lin_work1, lin_work0
        STO     [lin_to, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_n, exchange_entry, lin_i
        LOD     [lin_at], lin_work0
        ADDN    lin_work0, exc_unit, lin_work0
        STO     [lin_at], lin_work0
        ADDX    lin_from, lin_stride, lin_from
        ADDX    lin_to, lin_stride, lin_to
        ADDX    lin_at, lin_stride, lin_at
        IX      lin_at, 64
        IBXNE   lin_left, lin_minus_one, r0, exchange_column, lin_left

; Stores the irradiation from outside in H. Subtracts (e - 1) F_e J_e from b.
        ES      lin_i, 0
exchange_outer:
        LOD     [lin_from, lin_i], lin_work0
        LOD     [exc_spare, lin_i], lin_work1
        LOD     [lin_b, lin_i], lin_work2
        MPYS    lin_work0, exc_outside, lin_work0
        STO     [exc_h, lin_i], lin_work0
        MPYS    lin_work1, lin_work0, lin_work1
        SUBN    lin_work2, lin_work1, lin_work2
        STO     [lin_b, lin_i], lin_work2
        IBXNE   lin_i, lin_one, lin_n, exchange_outer, lin_i

        eliminate exchange_singular
        solve exchange_flows

; H := H + F_j J_j
exchange_flows:
        RTOR    exc_factors, lin_from
        RTOR    exc_h, lin_to
        RTOR    lin_n, lin_count
        ES      lin_k, 0
exchange_incident:
        LOD     [lin_x, lin_k], lin_work0
        add_times lin_work0
        ADDX    lin_from, lin_stride, lin_from
        IBXNE   lin_k, lin_one, lin_n, exchange_incident, lin_k

; Q = A (J - H). The spare column gets A F_e (J_e - J) of the environment.
        ES      lin_i, 0
exchange_net:
        LOD     [lin_x, lin_i], lin_work0
        LOD     [exc_h, lin_i], lin_work1
        LOD     [exc_areas, lin_i], lin_work2
        SUBN    lin_work0, lin_work1, lin_work1
        MPYS    lin_work1, lin_work2, lin_work1
        STO     [exc_q, lin_i], lin_work1
        LOD     [lin_from, lin_i], lin_work1
        SUBN    exc_outside, lin_work0, lin_work0
        MPYS    lin_work0, lin_work1, lin_work0
        MPYS    lin_work0, lin_work2, lin_work0
        STO     [exc_spare, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_n, exchange_net, lin_i
        RTOR    lin_n, lin_left
        fold_words exc_spare
        LOD     [exc_spare], lin_work2
        STO     [exc_end], lin_work2
        ES      lin_i, 0
exchange_copy:
        LOD     [exc_q, lin_i], lin_work0
        STO     [exc_spare, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_n, exchange_copy, lin_i
        RTOR    lin_n, lin_left
        fold_words exc_spare
        LOD     [exc_spare], lin_work0
        LOD     [exc_end], lin_work2
        ADDN    lin_work0, lin_work2, lin_work0
        STO     [exc_end, lin_one], lin_work0
        EXIT

exchange_singular:
        ADDX    lin_k, lin_one, lin_k
        IX      exc_end, 128
        STO     [exc_end], lin_k
        EXIT
        .endkernel
