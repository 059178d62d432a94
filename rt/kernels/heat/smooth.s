; smooth.s - adjusts radiation flows so that those of a surface sum to its area.
;
; The adjusted flows are the nearest ones to the measured flows. The flow x_ij =
; A_i F_ij = x_ji was measured in both directions, with the variance v_ij. Flows
; to the environment (j = e) and from i to itself were measured in one
; direction. For each i, the adjusted flows y fulfil
;
;   y_i1 + .. + y_in + y_ie = A_i
;
; and they minimise the sum of (y_ij - x_ij)^2 / v_ij. With Lagrange's
; multipliers l_i they are
;
;   y_ij = x_ij + v_ij (l_i + l_j)
;   y_ii = x_ii + v_ii l_i     y_ie = x_ie + v_ie l_i
;
;   l_i + sum of v_ij l_j / d_i = (A_i - x_i1 - .. - x_in - x_ie) / d_i
;                                                      j not i, not e
;   d_i = v_i1 + .. + v_in + v_ie
;
; If d_i is 0 it is replaced by 1, so no flow of i is changed. Elimination
; (elimination.s) solves the equations. A diagonal below MIN_DIAGONAL occurs for
; surfaces that alternately see only each other, if their areas admit no
; solution.
;
; In:  the words below.
; Out: smooth_results: n + 1 columns y_1j .. y_nj, then l, then the number of the
;      surface, from 1, without a solution, or 0.
; Source: M. E. Larsen and J. R. Howell, "Least-squares smoothing of
; direct-exchange areas in zonal analysis", J. Heat Transfer 108 (1986); the
; equations are derived here.

        .include "heat/elimination.s"

        .data
smooth_arguments:
smooth_count:   .word 0                 ; surfaces, n, an integer
smooth_flows:   .word 0                 ; address of n + 1 columns x_1j .. x_nj
smooth_variances: .word 0               ; address of n + 1 columns v_1j .. v_nj
smooth_areas:   .word 0                 ; address of the plane A
smooth_matrix:  .word 0                 ; address of n columns, b, two planes
smooth_results: .word 0                 ; address of the results
                .word 1.0, 1e-12         ; 1, MIN_DIAGONAL
                .word 1, -1
                .equ    SMOOTH_ARGUMENTS, 10
smooth_bits:    .space 1 + 4096 / 64
        .code

        .regs   r10, lin_n, smo_flows, smo_variances, smo_areas, lin_matrix, smo_results
        .regs   r16, smo_unit, lin_least, lin_one, lin_minus_one
        .regs   r20, lin_stride, lin_b, smo_d, smo_sum
        .regs   r24, lin_x, smo_end     ; l; the word after it

        .regs   r50, smo_bits, variance, flow, weight, sum, area, right, entry, multiplier, adjusted
        .regs   r60, at_variance, at_flow, at_entry, at_adjusted

        planes  lin_i, lin_one, lin_n, lin_scratch, smo_bits

        .entry  smooth
        .kernel smooth
smooth:
        load_words smooth_arguments, SMOOTH_ARGUMENTS, lin_n, lin_work
        SHIFTI  lin_n, 6, lin_stride
        MPYX    lin_n, lin_stride, lin_b
        ADDX    smo_results, lin_b, lin_x
        ADDX    lin_x, lin_stride, lin_x
        ADDX    lin_x, lin_stride, smo_end
        ADDX    lin_matrix, lin_b, lin_b
        ADDX    lin_b, lin_stride, smo_d
        ADDX    smo_d, lin_stride, smo_sum

; weight = d = the sum of all columns of v, sum = the sum of all columns of x.
        each    smooth_row
        plane   smo_d, weight
        plane   smo_sum, sum
        column  smo_variances, variance
        column  smo_flows, flow
        fetch_into at_variance, variance, weight
        fetch_into at_flow, flow, sum
        RTOR    lin_n, lin_left
smooth_add:
        advance variance, lin_stride
        advance flow, lin_stride
        fetch   at_variance, variance
        fetch   at_flow, flow
        plus    weight, variance, weight
        plus    sum, flow, sum
        IBXNE   lin_left, lin_minus_one, r0, smooth_add, lin_left

; b = (A - sum) / d. A d of 0 is replaced by 1.
        conditions smooth_bits
        load    smo_areas, area
        plane   lin_b, right
        minus   area, sum, sum
        if_equal_number weight, r0, smooth_known
        then_set smo_unit, weight
        end_if  smooth_known
        quotient sum, weight, right
        store   weight, smo_d
        store   right, lin_b
        next    smooth_row

; The matrix is v / d, with 1 in the diagonal.
        column  smo_variances, variance
        column  lin_matrix, entry
        RTOR    lin_matrix, lin_at
        RTOR    lin_n, lin_left
smooth_column:
        each    smooth_entry
        fetch   at_variance, variance
        fetch   smo_d, weight
        quotient variance, weight, entry
        store   entry, at_entry
        next    smooth_entry
        STO     [lin_at], smo_unit
        advance variance, lin_stride
        advance entry, lin_stride
        ADDX    lin_at, lin_stride, lin_at
        IX      lin_at, 64
        IBXNE   lin_left, lin_minus_one, r0, smooth_column, lin_left

        eliminate smooth_singular
        solve   smooth_flow

; y = x + v (l + l_j); in the diagonal y = x + v l_j.
smooth_flow:
        column  smo_variances, variance
        column  smo_flows, flow
        column  smo_results, adjusted
        plane   lin_x, multiplier
        ES      lin_k, 0
smooth_next:
        LOD     [lin_x, lin_k], lin_pivot
        each    smooth_word
        fetch   lin_x, multiplier
        fetch   at_variance, variance
        fetch   at_flow, flow
        raise   multiplier, lin_pivot, adjusted
        set_word lin_k, lin_pivot, adjusted
        times   adjusted, variance, adjusted
        plus    adjusted, flow, adjusted
        store   adjusted, at_adjusted
        next    smooth_word
        advance variance, lin_stride
        advance flow, lin_stride
        advance adjusted, lin_stride
        IBXNE   lin_k, lin_one, lin_n, smooth_next, lin_k

; Flows to the environment: y = x + v l.
        each    smooth_outer
        fetch   lin_x, multiplier
        fetch   at_variance, variance
        fetch   at_flow, flow
        times   multiplier, variance, adjusted
        plus    adjusted, flow, adjusted
        store   adjusted, at_adjusted
        next    smooth_outer
        EXIT

smooth_singular:
        ADDX    lin_k, lin_one, lin_k
        STO     [smo_end], lin_k
        EXIT
        .endkernel
