; test: one income, which is the limit itself
; tolerance: tax 1e-9

        .warm
        .equ    n, 1
        .data
limit:  .word   1000.0
low:    .word   0.25
high:   .word   0.5
income: .word   1000.0
want_tax:
        .word   250.0
want_above:
        .word   1
