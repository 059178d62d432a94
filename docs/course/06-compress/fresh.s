; test: another number of equations
; tolerance: t 1e-9

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 3 + draw % 80
        .endif

; One equation in six has a root, as in test-rays.s.
        .warm
        .data
a:      .rept   n
        .word   1.0 + 0.25 * float((\+ * 5 + draw) % 17)
        .endr
b:      .rept   n
        .word   20.0 + float((\+ * 3 + draw * 7) % 23)
        .endr
d:      .rept   n
        .if     (\+ * 5 + draw) % 6 == 0
        .word   float((\+ * 7 + draw * 3) % 29) * 6.25
        .else
        .word   -1.0 - float((\+ + draw) % 13)
        .endif
        .endr
want_t: .space  n
want_hits:
        .space  1
