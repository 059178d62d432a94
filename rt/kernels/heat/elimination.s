; elimination.s - equations A x = b are solved, with A by columns; what the two forms have in
; common.
;
; By Gaussian elimination, column by column:
;
;   L = A(k+1 .., k) / A(k, k)      A(k+1 .., j) := A(k+1 .., j) - A(k, j) L     j > k, and b
;
; without pivoting, for systems in which no row's other words exceed its diagonal in sum,
; which elimination keeps so.  A diagonal below lin_least ends it: there is no solution.
; Then from the last on: x_k = b_k / A(k, k), and b less A(1 .., k) x_k above.
;
;       eliminate singular              ; to singular: lin_k = the row, from 0 on
;       solve solved                    ; then to solved
;
; In:  lin_n, 1 or more; lin_stride from a column to the next, in bits; addresses lin_matrix,
;      lin_b = of the column behind it, lin_x; lin_least; lin_one, lin_minus_one.
; Out: x; A and b are lost.
; Source: Wilkinson, The Algebraic Eigenvalue Problem (1965), 4.

        .regs   r30, lin_column, lin_left, lin_at, lin_work0, lin_work1, lin_work2
        .regs   r36, lin_pivot, lin_k, lin_below, lin_row, lin_half, lin_upper
