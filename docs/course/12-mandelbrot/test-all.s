; test: no point ever leaves
; tolerance: counts 0.1
        .equ    n, 5
        .equ    most, 12
        .warm
        .data
cx:     .word   0.0, -0.1, 0.1, -1.0, -0.5
cy:     .word   0.0, 0.1, 0.0, 0.0, 0.25
want_counts:
        .word   12, 12, 12, 12, 12
want_total:
        .word   60.0
