; test: a picture of one pixel
; tolerance: clean 1e-9

        .warm
        .equ    rows, 1
        .equ    columns, 1
        .data
raw:    .word   7.0
dark:   .word   1.5
gain:   .word   2.0
want_clean:
        .word   11.0
