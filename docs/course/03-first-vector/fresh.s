; test: a picture of another size
; tolerance: clean 1e-9

        .ifdef  test_rows
        .equ    rows, test_rows
        .equ    columns, test_columns
        .else
        .equ    rows, 2 + draw % 7
        .equ    columns, 2 + draw % 11
        .endif

        .warm
        .data
raw:    .rept   rows * columns
        .word   float((\+ * 37 + draw * 101) % 251) + 0.5
        .endr
dark:   .rept   rows * columns
        .word   float((\+ * 3 + draw) % 11)
        .endr
gain:   .rept   rows * columns
        .word   1.25 + 0.125 * float((\+ * 5 + draw * 3) % 13)
        .endr
want_clean:
        .space  rows * columns
