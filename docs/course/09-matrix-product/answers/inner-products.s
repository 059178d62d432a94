; inner-products.s - each number of c by an inner product; each row of a is gathered once.

        .include "core.s"

        .ifndef m                       ; the tests define it
        .equ    m, 3                    ; rows of a and c
        .equ    n, 2                    ; columns of a, rows of b
        .equ    p, 2                    ; columns of b and c
        .endif

        .data
a:      .rept   m * n
        .word   \+.0 + 1
        .endr
b:      .rept   n * p
        .word   10.0 - \+ * 3
        .endr
c:      .space  m * p

row:    .space  n
        .code

        .regs   r10, a_row, row_of_a, b_column, c_row, c_at, period, word
        .regs   r20, b_bits, c_bits, rows, columns, i, j, one
        .regs   r30, upper, lower

        descriptor row_of_a, row, n
        EX      a_row, a
        EX      c_row, c
        EX      b_bits, 64 * n          ; bits of a column of b
        EX      c_bits, 64 * m
        ES      period, m
        ES      word, 64
        ES      one, 1
        ES      rows, m
        ES      columns, p
        ES      i, 0

        .kernel product
next_row:
        VGATHP  period, [a_row], [row_of_a]
        descriptor b_column, b, n
        RTOR    c_row, c_at
        ES      j, 0
next:   DOTV    [row_of_a], [b_column], upper
        join_parts upper, lower, upper
        STO     [c_at], upper
        ADDX    c_at, c_bits, c_at
        ADDX    b_column, b_bits, b_column
        IBXLT   j, one, columns, next, j
        ADDX    a_row, word, a_row
        ADDX    c_row, word, c_row
        IBXLT   i, one, rows, next_row, i
        .endkernel
        EXIT
; expect: [c] = 38.0, 55.0, 72.0
; expect: [c + 64 * m] = 8.0, 13.0, 18.0
