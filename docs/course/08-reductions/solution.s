; solution.s - weighted sums of the rows of a matrix, the maximum and the mean.
;
;   score(i) = sum over j of weights(j) marks(i, j)
;
; Each column, times its weight, is added to the vector of scores.  The only reductions are
; those of this vector.

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    m, 4
        .equ    n, 3
        .endif

        .data
marks:  .rept   m * n
        .word   float(\+ * 5 % 7)
        .endr
weights:
        .rept   n
        .word   1.0 + 0.5 * \+
        .endr
scores: .space  m
best:   .space  1
top:    .space  1
mean:   .space  1

column: .space  m
        .code

        .regs   r10, columns, products, sums, from, weight_at, j
        .regs   r16, total, lower
        .regs   r20, period, one, word, count, rows, factor, at, index, value

        descriptor columns, column, m
        descriptor products, column, m  ; not stored
        descriptor sums, scores, m
        EX      from, marks
        EX      weight_at, weights
        ES      period, n
        ES      count, n
        ES      one, 1
        ES      word, 64
        ES      j, 1
        load_constant rows, float(m)

        .kernel score
        LOD     [weight_at], factor
        VGATHP  period, [from], [columns]
        MPYSV   [columns], factor, [sums]
        IBXLE   count, r0, one, reduce  ; there is only one column
next:   ADDX    from, word, from
        ADDX    weight_at, word, weight_at
        LOD     [weight_at], factor
        VGATHP  period, [from], [columns]
        LINKV
        MPYSV   [columns], factor, [products]
        ADDNV   [products], [sums], [sums]
        IBXLT   j, one, count, next, j
        .endkernel

        .kernel reduce
reduce: SUMV    [sums], total
        MAXV    [sums], index, value
        join_parts total, lower, total
        DIVS    total, rows, total
        EX      at, best
        STO     [at], index
        EX      at, top
        STO     [at], value
        EX      at, mean
        STO     [at], total
        .endkernel
        EXIT
; expect: [scores] = 13.5, 18.0, 12.0, 16.5
; expect: [best] = 1, 18.0, 15.0
