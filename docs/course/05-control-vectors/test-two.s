; test: one below the limit, one above
; tolerance: tax 1e-9

        .warm
        .equ    n, 2
        .data
limit:  .word   1000.0
low:    .word   0.25
high:   .word   0.5
income: .word   800.0, 1200.0
want_tax:
        .word   200.0, 350.0
want_above:
        .word   1
