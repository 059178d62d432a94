; test: five elements
        .equ    n, 5
        .warm
        .data
x:      .word   1.0, -2.0, 3.5, 1e3, 0.0
want_y: .word   2.0, -4.0, 7.0, 2e3, 0.0
want_above: .word 1
