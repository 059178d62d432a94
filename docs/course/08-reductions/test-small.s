; test: four rows of three, two of them with the highest score
; tolerance: scores 1e-9
; tolerance: top 1e-9
; tolerance: mean 1e-9
        .equ    m, 4
        .equ    n, 3
        .warm
        .data
marks:  .word   1.0, 2.0, 3.0
        .word   4.0, 6.0, 8.0
        .word   0.0, -1.0, 0.5
        .word   4.0, 6.0, 8.0
weights:
        .word   1.0, 0.5, 2.0
want_scores:
        .word   8.0, 23.0, 0.5, 23.0
want_best:
        .word   1
want_top:
        .word   23.0
want_mean:
        .word   13.625
