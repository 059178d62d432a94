; test: other points, and another number of steps
; tolerance: counts 0.1

        .ifdef  test_n
        .equ    n, test_n
        .equ    most, test_most
        .else
        .equ    n, 3 + draw % 60
        .equ    most, 5 + draw % 40
        .endif

; The points are those of test-large.s in another order, moved by parts of their distance.
        .equ    right, float(draw % 97) * 0.0003721
        .equ    up, float(draw % 89) * 0.0004917

        .warm
        .data
cx:     .rept   n
        .word   float((\+ * 1331 + draw) % 4000 % 80) * 0.0375 - 2.2 + right
        .endr
cy:     .rept   n
        .word   float((\+ * 1331 + draw) % 4000 / 80) * 0.047 - 1.17 + up
        .endr
want_counts:
        .space  n
want_total:
        .space  1
