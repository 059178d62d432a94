; test: 4,000 points, 50 steps; the total checks all counts
; tolerance: counts 0.1
; goals: gold 400000, silver 560000, bronze 950000
        .equ    n, 4000
        .equ    most, 50
        .warm
        .data
cx:     .rept   n                       ; rows of 80 points
        .word   float(\+ % 80) * 0.0375 - 2.2
        .endr
cy:     .rept   n
        .word   float(\+ / 80) * 0.047 - 1.17
        .endr

; No count changes if all points are moved by 1e-10, so the order of operations is free.
want_counts:
        .rept   51                      ; the first row up to its middle
        .word   1 + (\+ > 15) + (\+ > 26)
        .endr
want_total:
        .word   60471.0
