; start.s - weighted sums of the rows of a matrix, the maximum and the mean.
;
;   score(i) = sum over j of weights(j) marks(i, j)

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    m, 4                    ; rows
        .equ    n, 3                    ; columns
        .endif

        .data
marks:  .rept   m * n                   ; row after row
        .word   float(\+ * 5 % 7)
        .endr
weights:
        .rept   n
        .word   1.0 + 0.5 * \+
        .endr
scores: .space  m
best:   .space  1                       ; the row with the highest score, an integer
top:    .space  1                       ; that score
mean:   .space  1                       ; of all scores

; your code here: vectors for intermediate results
        .code

        .regs   r10, rows

        load_constant rows, float(m)    ; to divide by

        .kernel score
; your code here
        .endkernel

        .kernel reduce
; your code here
        .endkernel
        EXIT
; expect: [scores] = 13.5, 18.0, 12.0, 16.5
; expect: [best] = 1, 18.0, 15.0
