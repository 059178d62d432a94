; test: 8 columns with 0 to 5 elements
        .equ    n, 8
        .equ    m, 12
        .warm

        .data
lengths:
        .word   2, 0, 5, 1, 1, 2, 1, 0
l:      .word   2.0, -1.0
        .word   3.0, 0.0, 1.0, -2.0, 4.0
        .word   0.5
        .word   -1.0
        .word   1.0, 2.0
        .word   8.0
x:      .word   1.0, 4.0, 3.0, 12.0, 9.0, -1.0, 7.0, 100.0
want_x: .word   1.0, 2.0, 4.0, 0.0, 9.0, 4.0, 11.0, -12.0
