; test: another number of points
; tolerance: v 1e-9
; tolerance: x 1e-9

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 2 + draw % 90
        .endif

        .warm
        .data
h:      .word   float(1 + draw % 61) / 64
f:      .rept   n
        .word   float((\+ * 29 + draw * 7) % 101) - 50.5
        .endr
v:      .rept   n
        .word   float((\+ * 13 + draw * 3) % 67) - 20.0
        .endr
x:      .rept   n
        .word   float((\+ * 17 + draw) % 997)
        .endr
want_v: .space  n
want_x: .space  n
