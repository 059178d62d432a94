; matrix_2.s - computes c := a b by inner products. Each column of b is
; gathered once, because its elements are one row apart in memory.

        .include "matrix_data.inc"

        .regs   r10, a_row, b_column, c_column, c_at, column, index, i, j
        .regs   r20, upper, lower, sum, one, count, word, row

        .data
rows:   .rept   n
        .word   \+ * n
        .endr
t:      .space  n
        .code

        descriptor index, rows, n
        descriptor column, t, n
        EX      b_column, b
        EX      c_column, c
        EX      count, n
        ES      one, 1
        ES      word, 64
        EX      row, ROW
        ES      j, 0

        .kernel product
next_column:
        VXTOV   [index], [b_column], [column]
        descriptor a_row, a, n
        RTOR    c_column, c_at
        ES      i, 0
next_row:
        DOTV    [a_row], [column], upper
        join_parts upper, lower, sum
        STO     [c_at], sum
        ADDX    a_row, row, a_row
        ADDX    c_at, row, c_at
        IBXLT   i, one, count, next_row, i
        ADDX    b_column, word, b_column
        ADDX    c_column, word, c_column
        IBXLT   j, one, count, next_column, j
        .endkernel
        EXIT
; expect: [c] = 1715124.0, 1716252.0, 1717380.0, 1718508.0
; expect: [c + 64 * (n * n - 2)] = 128951268.0, 129060684.0
