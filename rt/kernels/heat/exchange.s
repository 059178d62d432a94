; exchange.s - computes the radiation between grey diffuse surfaces.
;
; Surface i has the area A_i, the
; emissivity e_i and the temperature T_i. J_i is its radiosity, H_i its
; irradiation, F_ij the view factor from i to j. Beyond the surfaces is the
; environment, black, with the temperature T_e:
;
;   J_i = e_i sigma T_i^4 + (1 - e_i) H_i
;   H_i = F_i1 J_1 + .. + F_in J_n + F_ie sigma T_e^4
;   Q_i = A_i (J_i - H_i)           net heat loss, a flow
;   Q_e = sum of A_i F_ie (sigma T_e^4 - J_i)
;
; An adiabatic surface has the emissivity 0: it reflects its whole irradiation.
;
; Elimination (elimination.s) solves (I - (1 - e) F) J = b. A diagonal below
; MIN_DIAGONAL occurs if an exchange has no solution: adiabatic surfaces that
; see only each other.
;
; In:  the words below.
; Out: exchange_results: planes J, H, Q of n words, then Q_e, the sum of all
;      flows, and the number of the surface, from 1, without a solution, or 0.
; Source: Hottel and Sarofim, Radiative Transfer (1967); sigma: CODATA 2018.

        .include "heat/elimination.s"
        .include "heat/fold.s"

        .data
exchange_arguments:
exchange_count: .word 0                 ; surfaces, n, an integer
exchange_factors: .word 0               ; address of n + 1 columns F_1j .. F_nj
exchange_areas: .word 0                 ; address of the plane A
exchange_emissivities: .word 0          ; address of the plane e
exchange_temperatures: .word 0          ; address of the plane T
exchange_matrix: .word 0                ; address of n columns, b and a column
exchange_results: .word 0               ; address of the results
exchange_outside: .word 0.0             ; T_e
                .word 5.670374419e-8    ; sigma
                .word 1.0, 1e-12         ; 1, MIN_DIAGONAL
                .word 1, -1
                .equ    EXCHANGE_ARGUMENTS, 13
        .code

        .regs   r10, lin_n, exc_factors, exc_areas, exc_emissivities, exc_temperatures
        .regs   r15, lin_matrix, lin_x, exc_outside, exc_sigma, exc_unit, lin_least
        .regs   r21, lin_one, lin_minus_one
        .regs   r23, lin_stride         ; bits between columns, or planes
        .regs   r24, lin_b, exc_spare   ; addresses of b and of the next column
        .regs   r26, exc_h, exc_q, exc_end

        .regs   r50, factor, emissivity, rest, right, radiosity, irradiation, area, net, entry, exc_bits
        .regs   r60, at_factor, at_entry

        planes  lin_i, lin_one, lin_n, lin_scratch, exc_bits

        .entry  exchange
        .kernel exchange
exchange:
        load_words exchange_arguments, EXCHANGE_ARGUMENTS, lin_n, lin_work
        SHIFTI  lin_n, 6, lin_stride
        MPYX    lin_n, lin_stride, lin_b
        ADDX    lin_matrix, lin_b, lin_b
        ADDX    lin_b, lin_stride, exc_spare
        ADDX    lin_x, lin_stride, exc_h
        ADDX    exc_h, lin_stride, exc_q
        ADDX    exc_q, lin_stride, exc_end
        MPYS    exc_outside, exc_outside, exc_outside
        MPYS    exc_outside, exc_outside, exc_outside
        MPYS    exc_sigma, exc_outside, exc_outside     ; J of the environment

; b = e sigma T^4; the spare column: e - 1.
        plane   exc_spare, rest
        plane   lin_b, right
        each    exchange_right
        load    exc_temperatures, factor
        load    exc_emissivities, emissivity
        times   factor, factor, right
        times   right, right, right
        scale   right, exc_sigma, right
        times   right, emissivity, right
        lower   emissivity, exc_unit, rest
        store   right, lin_b
        store   rest, exc_spare
        next    exchange_right

; Computes the columns of the matrix and its diagonal.
        column  exc_factors, factor
        column  lin_matrix, entry
        RTOR    lin_n, lin_left
        RTOR    lin_matrix, lin_at
exchange_column:
        each    exchange_entry
        fetch   exc_spare, rest
        fetch   at_factor, factor
        times   rest, factor, entry
        store   entry, at_entry
        next    exchange_entry
        LOD     [lin_at], lin_work
        ADDN    lin_work, exc_unit, lin_work
        STO     [lin_at], lin_work
        advance factor, lin_stride
        advance entry, lin_stride
        ADDX    lin_at, lin_stride, lin_at
        IX      lin_at, 64
        IBXNE   lin_left, lin_minus_one, r0, exchange_column, lin_left

; Stores the irradiation from outside in H. Subtracts (e - 1) F_e J_e from b.
        plane   exc_h, irradiation
        plane   exc_q, net
        each    exchange_outer
        fetch   at_factor, factor
        fetch   exc_spare, rest
        fetch   lin_b, right
        scale   factor, exc_outside, irradiation
        store   irradiation, exc_h
        times   rest, irradiation, net
        minus   right, net, right
        store   right, lin_b
        next    exchange_outer

        eliminate exchange_singular
        solve   exchange_flows

; H := H + F_j J_j
exchange_flows:
        plane   exc_h, irradiation
        column  exc_factors, factor
        ES      lin_k, 0
exchange_incident:
        LOD     [lin_x, lin_k], lin_work
        each    exchange_add
        fetch   at_factor, factor
        fetch   exc_h, irradiation
        scaled_plus factor, lin_work, irradiation, irradiation
        store   irradiation, exc_h
        next    exchange_add
        advance factor, lin_stride
        IBXNE   lin_k, lin_one, lin_n, exchange_incident, lin_k

; Q = A (J - H). The spare column gets A F_e (J_e - J) of the environment.
        each    exchange_net
        load    lin_x, radiosity
        fetch   exc_h, irradiation
        plane   exc_q, net
        load    exc_areas, area
        minus   radiosity, irradiation, net
        times   net, area, net
        store   net, exc_q
        plane   exc_spare, rest
        fetch   at_factor, factor
        from    exc_outside, radiosity, rest
        times   rest, factor, rest
        times   rest, area, rest
        store   rest, exc_spare
        next    exchange_net
        RTOR    lin_n, lin_left
        fold    exc_spare, lin_left, lin_one, lin_at
        LOD     [exc_spare], lin_pivot
        STO     [exc_end], lin_pivot
        each    exchange_copy
        fetch_into exc_q, net, rest
        store   rest, exc_spare
        next    exchange_copy
        RTOR    lin_n, lin_left
        fold    exc_spare, lin_left, lin_one, lin_at
        LOD     [exc_spare], lin_work
        ADDN    lin_work, lin_pivot, lin_work
        STO     [exc_end, lin_one], lin_work
        EXIT

exchange_singular:
        ADDX    lin_k, lin_one, lin_k
        IX      exc_end, 128
        STO     [exc_end], lin_k
        EXIT
        .endkernel
