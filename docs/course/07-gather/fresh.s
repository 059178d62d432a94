; test: other numbers of points and cells
; tolerance: y 1e-9

        .ifdef  test_n
        .equ    n, test_n
        .equ    m, test_m
        .else
        .equ    n, 10 + 7 * (draw % 20)
        .equ    m, 2 + draw % 9
        .endif

; The steps of cells and places are those of test-large.s.
        .warm
        .data
cell:   .rept   n
        .word   (\+ * 7 + draw) % m + 1
        .endr
x:      .rept   n
        .word   float((\+ * 11 + draw * 5) % 61) / 64
        .endr
place:  .rept   n
        .word   (\+ * 7 + draw) % n
        .endr
table:  .rept   m
        .word   float((\+ * 23 + draw * 3) % 101), float((\+ * 5 + draw) % 19) - 9.5
        .word   float((\+ * 3 + draw * 11) % 37) - 18.0, 0
        .endr
want_y: .space  n
