; matrix_4.s - computes c := a b by rows, as in matrix_3.s. A link passes each
; product to the sum, so there is one start-up, and no product is stored.

        .include "matrix_data.inc"

        .regs   r10, a_at, b_row, c_row, t_row, i, k
        .regs   r20, factor, one, count, word, row


        descriptor t_row, c, n          ; never stored
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
        LINKV
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
