; candidate-by-candidate.s - an inner product for each row.

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

        .code

        .regs   r10, row, weight, sums, score_at, i, one
        .regs   r16, total, lower
        .regs   r20, bits, word, count, rows, at, index, value

        descriptor row, marks, n
        descriptor weight, weights, n
        descriptor sums, scores, m
        EX      score_at, scores
        EX      bits, 64 * n            ; the size of a row
        ES      word, 64
        ES      count, m
        ES      one, 1
        ES      i, 0
        load_constant rows, float(m)

        .kernel score
next:   DOTV    [row], [weight], total
        join_parts total, lower, total
        STO     [score_at], total
        ADDX    row, bits, row
        ADDX    score_at, word, score_at
        IBXLT   i, one, count, next, i
        .endkernel

        .kernel reduce
        SUMV    [sums], total
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
