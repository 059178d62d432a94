; rows-gathered.s - by rows, as for storage by rows; the rows are gathered and scattered.

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

row:    .space  p
sum:    .space  p
        .code

        .regs   r10, a_row, a_at, b_row, row_of_b, c_row, row_of_c, factor, word
        .regs   r20, a_period, b_period, a_bits, rows, terms, i, k, one

        descriptor row_of_b, row, p
        descriptor row_of_c, sum, p
        EX      a_row, a
        EX      c_row, c
        EX      a_bits, 64 * m          ; bits of a column of a
        ES      a_period, m
        ES      b_period, n
        ES      word, 64
        ES      one, 1
        ES      rows, m
        ES      terms, n
        ES      i, 0

        .kernel product
next_row:
        EX      b_row, b
        RTOR    a_row, a_at
        VTOV    r0, [row_of_c]
        ES      k, 0
next:   VGATHP  b_period, [b_row], [row_of_b]
        LOD     [a_at], factor
        LINKV
        MPYSV   [row_of_b], factor, [row_of_b]
        ADDNV   [row_of_b], [row_of_c], [row_of_c]
        ADDX    b_row, word, b_row
        ADDX    a_at, a_bits, a_at
        IBXLT   k, one, terms, next, k
        VSCATP  a_period, [row_of_c], [c_row]
        ADDX    a_row, word, a_row
        ADDX    c_row, word, c_row
        IBXLT   i, one, rows, next_row, i
        .endkernel
        EXIT
; expect: [c] = 38.0, 55.0, 72.0
; expect: [c + 64 * m] = 8.0, 13.0, 18.0
