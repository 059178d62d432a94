; test: other numbers of rows and columns
; tolerance: scores 1e-9
; tolerance: top 1e-9
; tolerance: mean 1e-9

        .ifdef  test_n
        .equ    m, test_m
        .equ    n, test_n
        .else
        .equ    m, 2 + draw % 40
        .equ    n, 1 + draw % 11
        .endif

; All sums are exact, so their order is free.
        .warm
        .data
marks:  .rept   m * n
        .word   float((\+ * \+ * 7 + \+ * 89 + draw * 31) % 509) - 200.0
        .endr
weights:
        .rept   n
        .word   float((\+ * 3 + draw * 5) % 15 + 1) / 8
        .endr
want_scores:
        .space  m
want_best:
        .space  1
want_top:
        .space  1
want_mean:
        .space  1
