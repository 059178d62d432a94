; test: matrices of other sizes
; tolerance: c 1e-6

        .ifdef  test_n
        .equ    m, test_m
        .equ    n, test_n
        .equ    p, test_p
        .else
        .equ    m, 1 + draw % 13
        .equ    n, 1 + draw % 7
        .equ    p, 1 + draw % 5
        .endif

        .warm
        .data
a:      .rept   m * n
        .word   float((\+ * \+ * 3 + \+ * 17 + draw * 7) % 61) - 30.0
        .endr
b:      .rept   n * p
        .word   float((\+ * \+ * 5 + \+ * 13 + draw * 11) % 47) - 20.5
        .endr
want_c: .space  m * p
