; solution.s - c := a b for matrices that are stored by columns.
;
; Column j of c is the sum of the columns of a, each times a number of column j of b.  The
; columns are contiguous, so they are the vectors.

        .include "core.s"

        .ifndef m                       ; the tests define it
        .equ    m, 3                    ; rows of a and c
        .equ    n, 2                    ; columns of a, rows of b
        .equ    p, 2                    ; columns of b and c
        .endif

        .data
a:      .rept   m * n
        .word   1.0 + \+
        .endr
b:      .rept   n * p
        .word   10.0 - \+ * 3
        .endr
c:      .space  m * p
        .code

        .regs   r10, a_column, c_column, products, b_at, column
        .regs   r20, factor, one, word, terms, columns, j, k

        descriptor c_column, c, m
        EX      b_at, b
        EX      column, 64 * m          ; bits of a column
        ES      word, 64
        ES      one, 1
        ES      terms, n
        ES      columns, p
        ES      j, 0

        .kernel product
next_column:
        descriptor a_column, a, m
        RTOR    c_column, products      ; not stored
        LOD     [b_at], factor
        MPYSV   [a_column], factor, [c_column]
        ADDX    b_at, word, b_at
        ES      k, 1
        IBXGE   k, r0, terms, done
next:   LOD     [b_at], factor
        ADDX    a_column, column, a_column
        ADDX    b_at, word, b_at
        LINKV
        MPYSV   [a_column], factor, [products]
        ADDNV   [products], [c_column], [c_column]
        IBXLT   k, one, terms, next, k
done:   ADDX    c_column, column, c_column
        IBXLT   j, one, columns, next_column, j
        .endkernel
        EXIT
; expect: [c] = 38.0, 55.0, 72.0
; expect: [c + 64 * m] = 8.0, 13.0, 18.0
