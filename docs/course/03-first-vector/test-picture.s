; test: 64 rows of 60 pixels
; tolerance: clean 1e-9
; goals: gold 4050, silver 11000, bronze 160000

        .warm
        .equ    rows, 64
        .equ    columns, 60
        .data
raw:
        .rept   rows * columns
        .word   float(\+ * 7 % 251)
        .endr
dark:
        .rept   rows * columns
        .word   float(\+ % 5)
        .endr
gain:
        .rept   rows * columns
        .word   1.0 + 0.125 * float(\+ % 3)
        .endr
want_clean:
        .rept   rows * columns
        .word   (float(\+ * 7 % 251) - float(\+ % 5)) * (1.0 + 0.125 * float(\+ % 3))
        .endr
