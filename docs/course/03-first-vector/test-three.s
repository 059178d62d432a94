; test: a picture of one row, three pixels long
; tolerance: clean 1e-9

        .warm
        .equ    rows, 1
        .equ    columns, 3
        .data
raw:    .word   7.0, 5.0, 3.0
dark:   .word   1.0, 1.0, 2.0
gain:   .word   2.0, 0.25, -1.0
want_clean:
        .word   12.0, 1.0, -1.0
