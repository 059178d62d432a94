; test: large scores of both signs, whose sum is small
; tolerance: scores 1e-9
; tolerance: top 1e-9
; tolerance: mean 1e-9
        .equ    m, 3
        .equ    n, 1
        .warm
        .data
marks:  .word   1e15, 3.0, -1e15
weights:
        .word   1.0
want_scores:
        .word   1e15, 3.0, -1e15
want_best:
        .word   0
want_top:
        .word   1e15
want_mean:
        .word   1.0
