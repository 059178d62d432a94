; test: one row of one number, below zero
; tolerance: scores 1e-9
; tolerance: top 1e-9
; tolerance: mean 1e-9
        .equ    m, 1
        .equ    n, 1
        .warm
        .data
marks:  .word   -3.0
weights:
        .word   2.0
want_scores:
        .word   -6.0
want_best:
        .word   0
want_top:
        .word   -6.0
want_mean:
        .word   -6.0
