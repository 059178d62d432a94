; matrix_1.s - computes c := a b with numbers in three nested loops.

        .include "matrix_data.inc"

        .regs   r10, a_row, b_column, c_at, a_at, b_at, i, j, k
        .regs   r20, left, right, product, sum, one, count, word, row

        EX      a_row, a
        EX      c_at, c
        EX      count, n
        ES      one, 1
        ES      word, 64
        EX      row, ROW
        ES      i, 0

        .kernel product
next_row:
        EX      b_column, b
        ES      j, 0
next_column:
        RTOR    a_row, a_at
        RTOR    b_column, b_at
        ES      k, 0
        ES      sum, 0
next:   LOD     [a_at], left
        LOD     [b_at], right
        MPYS    left, right, product
        ADDN    sum, product, sum
        ADDX    a_at, word, a_at
        ADDX    b_at, row, b_at
        IBXLT   k, one, count, next, k
        STO     [c_at], sum
        ADDX    c_at, word, c_at
        ADDX    b_column, word, b_column
        IBXLT   j, one, count, next_column, j
        ADDX    a_row, row, a_row
        IBXLT   i, one, count, next_row, i
        .endkernel
        EXIT
; expect: [c] = 1715124.0, 1716252.0, 1717380.0, 1718508.0
; expect: [c + 64 * (n * n - 2)] = 128951268.0, 129060684.0
