; elimination.s - solves equations A x = b, with A stored by columns.
;
; The method is Gaussian elimination, column by column:
;
;   L = A(k+1 .., k) / A(k, k)
;   A(k+1 .., j) := A(k+1 .., j) - A(k, j) L     for j > k, and for b
;
; There is no pivoting, so the sum of the other words of a row must not exceed
; its diagonal. Elimination preserves this property. A diagonal below lin_least
; ends the elimination: there is no solution. Back substitution goes from the
; last row to the first: x_k = b_k / A(k, k), then A(1 .., k) x_k is subtracted
; from b.
;
;       eliminate singular              ; to singular: lin_k = the row, from 0
;       solve solved                    ; to solved when done
;
; In:  lin_n, 1 or more; lin_stride from a column to the next, in bits;
;      addresses lin_matrix, lin_b = of the column after it, lin_x; lin_least;
;      lin_one, lin_minus_one.
; Out: x; A and b are overwritten.
; Source: Wilkinson, The Algebraic Eigenvalue Problem (1965), 4.

        .include "points/planes.s"

        .regs   r30, lin_column, lin_left, lin_at, lin_work, lin_pivot, lin_k, lin_below, lin_row
        .regs   r38, lin_from, at_lin_entry, lin_i, lin_scratch
        .regs   r44, lin_factor, lin_entry

        .macro  eliminate singular
        RTOR    lin_matrix, lin_at
        ES      lin_k, 0
eliminate_step:
        LOD     [lin_at], lin_pivot
        CFPLT   lin_pivot, lin_least, \singular
        ADDX    lin_k, lin_one, lin_row
        SUBX    lin_n, lin_row, lin_below
        IBXEQ   lin_below, r0, r0, eliminated
        ADDX    lin_at, r0, lin_from
        IX      lin_from, 64
        each    eliminate_divide
        load    lin_from, lin_factor, lin_below
        over    lin_factor, lin_pivot, lin_factor
        store   lin_factor, lin_from
        next    eliminate_divide, lin_below
        ADDX    lin_at, lin_stride, lin_row     ; A(k, j)
        RTOR    lin_below, lin_left
eliminate_next:
        LOD     [lin_row], lin_work
        SUBN    r0, lin_work, lin_work
        column  lin_row, lin_entry, lin_below
        skip    lin_entry, 1
        each    eliminate_add
        fetch   lin_from, lin_factor
        fetch   at_lin_entry, lin_entry
        scaled_plus lin_factor, lin_work, lin_entry, lin_entry
        store   lin_entry, at_lin_entry
        next    eliminate_add, lin_below
        ADDX    lin_row, lin_stride, lin_row
        IBXGE   lin_left, lin_minus_one, r0, eliminate_next, lin_left
        IX      lin_at, 64
        ADDX    lin_at, lin_stride, lin_at
        IBXNE   lin_k, lin_one, lin_n, eliminate_step, lin_k
eliminated:
        .endm

        .macro  solve solved
        RTOR    lin_n, lin_k
        RTOR    lin_b, lin_column
solve_back:
        SUBX    lin_column, lin_stride, lin_column
        SUBX    lin_k, lin_one, lin_k
        LOD     [lin_column, lin_k], lin_pivot
        LOD     [lin_b, lin_k], lin_work
        DIVS    lin_work, lin_pivot, lin_work
        STO     [lin_x, lin_k], lin_work
        IBXEQ   lin_k, r0, r0, \solved
        SUBN    r0, lin_work, lin_work
        each    solve_add
        load    lin_column, lin_factor, lin_k
        load    lin_b, lin_entry, lin_k
        scaled_plus lin_factor, lin_work, lin_entry, lin_entry
        store   lin_entry, lin_b
        next    solve_add, lin_k
        BIM     solve_back
        .endm
