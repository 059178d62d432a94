; exchange.s - computes the radiation between grey diffuse surfaces.
;
; This is the common part of the two forms. Surface i has the area A_i, the
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
; MIN_DIAGONAL occurs if an exchange has no solution: adiabatic surfaces that see only
; each other.
;
; Sums are formed by halves: of m words, the last m / 2 are added to the first.
;
; In:  the words below.
; Out: exchange_results: planes J, H, Q of n words, then Q_e, the sum of all
;      flows, and the number of the surface, from 1, without a solution, or 0.
; Source: Hottel and Sarofim, Radiative Transfer (1967); sigma: CODATA 2018.

        .include "points/planes.s"
        .include "heat/elimination.s"

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
        .regs   r15, lin_matrix, exc_results, exc_outside, exc_sigma, exc_unit, lin_least
        .regs   r21, lin_one, lin_minus_one
        .regs   r23, lin_stride         ; bits between columns, or planes
        .regs   r24, lin_b, exc_spare   ; addresses of b and of the next column
        .regs   r26, lin_x, exc_h, exc_q, exc_end

        .macro  exchange_begin
        EX      lin_work0, exchange_arguments
        ELEN    lin_work0, EXCHANGE_ARGUMENTS
        SWAP    [lin_work0], lin_n, [r0]
        SHIFTI  lin_n, 6, lin_stride
        MPYX    lin_n, lin_stride, lin_b
        ADDX    lin_matrix, lin_b, lin_b
        ADDX    lin_b, lin_stride, exc_spare
        RTOR    exc_results, lin_x
        ADDX    lin_x, lin_stride, exc_h
        ADDX    exc_h, lin_stride, exc_q
        ADDX    exc_q, lin_stride, exc_end
        MPYS    exc_outside, exc_outside, exc_outside
        MPYS    exc_outside, exc_outside, exc_outside
        MPYS    exc_sigma, exc_outside, exc_outside     ; J of the environment
        .endm

        .entry  exchange
        by_hand heat/exchange
