; test: 300 rows of eight
; tolerance: scores 1e-9
; tolerance: top 1e-9
; tolerance: mean 1e-9
; goals: gold 5700, silver 6700, bronze 12000
        .equ    m, 300
        .equ    n, 8
        .warm
        .data

; Row i has q, q + 1, .. q + 7 with q = 7 i mod 300, the weights are 1/8, 2/8, .. 8/8: the
; score is 36 q / 8 + 168 / 8.  q takes each value from 0 to 299 once, the last in row 257.
marks:  .rept   m * n
        .word   float(\+ / n * 7 % m + \+ % n)
        .endr
weights:
        .rept   n
        .word   float(\+ + 1) / 8
        .endr
want_scores:
        .rept   m
        .word   4.5 * (\+ * 7 % m) + 21
        .endr
want_best:
        .word   257
want_top:
        .word   4.5 * 299 + 21
want_mean:
        .word   4.5 * 149.5 + 21
