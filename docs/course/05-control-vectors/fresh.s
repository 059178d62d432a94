; test: another number of incomes
; tolerance: tax 1e-6

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 3 + draw % 80
        .endif

; One income in ten is above the limit, as in test-town.s.
        .warm
        .data
limit:  .word   900.0 + draw % 7
low:    .word   0.125 + float(draw % 31) / 256
high:   .word   0.375 + float(draw % 29) / 128
income: .rept   n
        .word   float((\+ * 37 + draw * 611) % 1000) + draw % 7
        .endr
want_tax:
        .space  n
want_above:
        .space  1
