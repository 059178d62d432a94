; test: nobody reaches the limit
; tolerance: tax 1e-9

        .warm
        .equ    n, 3
        .data
limit:  .word   5000.0
low:    .word   0.25
high:   .word   0.5
income: .word   800.0, 1200.0, 0.0
want_tax:
        .word   200.0, 300.0, 0.0
want_above:
        .word   0
