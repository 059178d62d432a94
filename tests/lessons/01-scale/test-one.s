; test: one element
        .equ    n, 1
        .warm
        .data
x:      .word   1.0
want_y: .word   2.0
want_above: .word 0
