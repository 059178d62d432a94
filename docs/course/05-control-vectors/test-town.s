; test: 4,000 incomes, one in ten above the limit
; tolerance: tax 1e-6
; goals: gold 6500, silver 8600, bronze 240000

        .warm
        .equ    n, 4000
        .data
limit:  .word   900.0
low:    .word   0.2
high:   .word   0.35
income:
        .rept   n
        .word   float(\+ * 37 % 1000)
        .endr
want_tax:
        .rept   n
        .if     \+ * 37 % 1000 >= 900
        .word   0.2 * 900.0 + 0.35 * (float(\+ * 37 % 1000) - 900.0)
        .else
        .word   0.2 * float(\+ * 37 % 1000)
        .endif
        .endr
want_above:
        .word   400
