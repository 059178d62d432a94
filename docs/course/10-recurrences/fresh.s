; test: another number of elements
; tolerance: x 1e-9

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 2 + draw % 500
        .endif

        .warm
        .data
a:      .rept   n
        .word   float((\+ * 29 + draw * 7) % 37 - 18) / 20 * (\+ > 0)
        .endr
b:      .rept   n
        .word   float((\+ * 53 + draw * 11) % 101 - 50) / 8
        .endr
want_x: .space  n
