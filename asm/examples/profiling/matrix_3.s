; matrix_3.s - computes c := a b by rows. A row of c is the sum of the rows of
; b, each multiplied by an element of a. There is no gather and no reduction.

        .include "matrix_data.inc"

        .regs   r10, a_at, b_row, c_row, t_row, i, k
        .regs   r20, factor, one, count, word, row

        .data
t:      .space  n
        .code

        descriptor t_row, t, n
        descriptor c_row, c, n
        EX      a_at, a
        EX      count, n
        ES      one, 1
        ES      word, 64
        EX      row, ROW
        ES      i, 0

        .kernel product
next_row:
        descriptor b_row, b, n
        ES      k, 0
next:   LOD     [a_at], factor
        MPYSV   [b_row], factor, [t_row]
        ADDNV   [c_row], [t_row], [c_row]
        ADDX    a_at, word, a_at
        ADDX    b_row, row, b_row
        IBXLT   k, one, count, next, k
        ADDX    c_row, row, c_row
        IBXLT   i, one, count, next_row, i
        .endkernel
        EXIT
; expect: [c] = 1715124.0, 1716252.0, 1717380.0, 1718508.0
; expect: [c + 64 * (n * n - 2)] = 128951268.0, 129060684.0
