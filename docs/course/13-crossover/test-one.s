; test: a single column, with nothing below the diagonal
        .equ    n, 1
        .equ    m, 1
        .warm

        .data
lengths:
        .word   0
l:      .word   5.0
x:      .word   -7.5
want_x: .word   -7.5
