; smooth.s - flows between surfaces that are nearest to those that were found, of all in
; which each surface gives away all that it has; what the two forms have in common.
;
; Of the flow x_ij = A_i F_ij = x_ji both ways were found, together with the variance v_ij; of
; those to the environment, j = e, and of those of i to itself one.  What is nearest,
;
;   sum of (y_ij - x_ij)^2 / v_ij least        y_i1 + .. + y_in + y_ie = A_i    each i
;
; is, by Lagrange's multipliers l_i,
;
;   y_ij = x_ij + v_ij (l_i + l_j)     y_ii = x_ii + v_ii l_i     y_ie = x_ie + v_ie l_i
;
;   l_i + sum of v_ij l_j / d_i = (A_i - x_i1 - .. - x_in - x_ie) / d_i       j not i, not e
;   d_i = v_i1 + .. + v_in + v_ie
;
; Where d_i is 0 it counts as 1: no flow of i is changed.  Equations are solved by
; elimination (elimination.s); a diagonal below LEAST is that of surfaces that see none but each other,
; by turns, whose areas leave no way.
;
; In:  what stands below.
; Out: smooth_made: n + 1 columns y_1j .. y_nj, then l, then the number of the surface, from 1
;      on, where there was no solution, else 0.
; Source: M. E. Larsen and J. R. Howell, "Least-squares smoothing of direct-exchange areas in
; zonal analysis", J. Heat Transfer 108 (1986); the equations derived here.

        .include "heat/elimination.s"

        .data
smooth_given:
smooth_count:   .word 0                 ; surfaces, n, an integer
smooth_flows:   .word 0                 ; address of n + 1 columns x_1j .. x_nj
smooth_variances: .word 0               ; .. v_1j .. v_nj
smooth_areas:   .word 0                 ; .. of the plane A
smooth_matrix:  .word 0                 ; .. of room for n columns, b, and two planes
smooth_made:    .word 0                 ; .. of what is found
                .word 1.0, 1e-12         ; LEAST
                .word 1, -1
                .equ    SMOOTH_GIVEN, 10
        .code

        .regs   r10, lin_n, smo_flows, smo_variances, smo_areas, lin_matrix, smo_made
        .regs   r16, smo_unit, lin_least, lin_one, lin_minus_one
        .regs   r20, lin_stride, lin_b, smo_d, smo_sum
        .regs   r24, lin_x, smo_end     ; l; behind it

        .macro  smooth_begin
        EX      lin_work0, smooth_given
        ELEN    lin_work0, SMOOTH_GIVEN
        SWAP    [lin_work0], lin_n, [r0]
        SHIFTI  lin_n, 6, lin_stride
        MPYX    lin_n, lin_stride, lin_b
        ADDX    smo_made, lin_b, lin_x
        ADDX    lin_x, lin_stride, lin_x
        ADDX    lin_x, lin_stride, smo_end
        ADDX    lin_matrix, lin_b, lin_b
        ADDX    lin_b, lin_stride, smo_d
        ADDX    smo_d, lin_stride, smo_sum
        .endm

        .macro  smooth_end
        EXIT
smooth_singular:
        ADDX    lin_k, lin_one, lin_k
        STO     [smo_end], lin_k
        EXIT
        .endm
