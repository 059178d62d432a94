; exchange_vector.s - the exchange of exchange.s, by whole columns.

        .include "heat/elimination_vector.s"

; Replaces lin_left words at the address, at least one, by their sum.
        .macro  fold_words address
        BIM     fold_whole\@
fold_halve\@:
        ADDX    lin_left, lin_one, lin_half
        SHIFTI  lin_half, -1, lin_half
        SUBX    lin_left, lin_half, lin_left
        SHIFTI  lin_half, 6, lin_work0
        ADDLEN  \address, lin_left, lin_at
        ADDX    lin_at, lin_work0, lin_upper
        ADDNV   [lin_at], [lin_upper], [lin_at]
        RTOR    lin_half, lin_left
fold_whole\@:
        IBXNE   lin_left, r0, lin_one, fold_halve\@
        .endm

        .kernel exchange
exchange:
        exchange_begin
        ADDLEN  exc_emissivities, lin_n, v_e
        ADDLEN  exc_spare, lin_n, v_d
        ADDLEN  lin_b, lin_n, v_b

; b = e sigma T^4; the spare column: e - 1.
        ADDLEN  exc_temperatures, lin_n, v_a
        MPYSV   [v_a], [v_a], [v_b]
        MPYSV   [v_b], [v_b], [v_b]
        MPYSV   [v_b], exc_sigma, [v_b]
        MPYSV   [v_b], [v_e], [v_b]
        SUBNV   [v_e], exc_unit, [v_d]

; Computes the columns of the matrix and its diagonal.
        ADDLEN  exc_factors, lin_n, v_a
        ADDLEN  lin_matrix, lin_n, v_c
        RTOR    lin_n, lin_left
        RTOR    lin_matrix, lin_at
exchange_column:
        MPYSV   [v_d], [v_a], [v_c]
        LOD     [lin_at], lin_work0
        ADDN    lin_work0, exc_unit, lin_work0
        STO     [lin_at], lin_work0
        ADDX    v_a, lin_stride, v_a
        ADDX    v_c, lin_stride, v_c
        ADDX    lin_at, lin_stride, lin_at
        IX      lin_at, 64
        IBXNE   lin_left, lin_minus_one, r0, exchange_column, lin_left

; Stores the irradiation from outside in H. Subtracts (e - 1) F_e J_e from b.
        ADDLEN  exc_h, lin_n, v_c
        MPYSV   [v_a], exc_outside, [v_c]
        ADDLEN  exc_q, lin_n, v_a
        MPYSV   [v_d], [v_c], [v_a]
        SUBNV   [v_b], [v_a], [v_b]

        eliminate exchange_singular
        solve exchange_flows

; H := H + F_j J_j
exchange_flows:
        ADDLEN  exc_h, lin_n, v_b
        ADDLEN  exc_factors, lin_n, v_a
        ES      lin_k, 0
exchange_incident:
        LOD     [lin_x, lin_k], lin_work0
        RTOR    v_b, v_d
        LINKV
        MPYSV   [v_a], lin_work0, [v_d]
        ADDNV   [v_d], [v_b], [v_b]
        ADDX    v_a, lin_stride, v_a
        IBXNE   lin_k, lin_one, lin_n, exchange_incident, lin_k

; Q = A (J - H). The spare column gets A F_e (J_e - J) of the environment.
        ADDLEN  lin_x, lin_n, v_c
        ADDLEN  exc_q, lin_n, v_d
        ADDLEN  exc_areas, lin_n, v_e
        SUBNV   [v_c], [v_b], [v_d]
        MPYSV   [v_d], [v_e], [v_d]
        ADDLEN  exc_spare, lin_n, v_b
        SUBNV   exc_outside, [v_c], [v_b]
        MPYSV   [v_b], [v_a], [v_b]
        MPYSV   [v_b], [v_e], [v_b]
        RTOR    lin_n, lin_left
        fold_words exc_spare
        LOD     [exc_spare], lin_work2
        STO     [exc_end], lin_work2
        VTOV    [v_d], [v_b]
        RTOR    lin_n, lin_left
        fold_words exc_spare
        LOD     [exc_spare], lin_work0
        ADDN    lin_work0, lin_work2, lin_work0
        STO     [exc_end, lin_one], lin_work0
        EXIT

exchange_singular:
        ADDX    lin_k, lin_one, lin_k
        IX      exc_end, 128
        STO     [exc_end], lin_k
        EXIT
        .endkernel
