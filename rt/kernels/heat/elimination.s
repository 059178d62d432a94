; elimination.s - solves equations A x = b, with A stored by columns.
;
; This is the common part of the two forms. The method is Gaussian elimination,
; column by column:
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

        .regs   r30, lin_column, lin_left, lin_at, lin_work0, lin_work1, lin_work2
        .regs   r36, lin_pivot, lin_k, lin_below, lin_row, lin_half, lin_upper
