; test: one column times one row: all products
; tolerance: c 1e-9
        .equ    m, 4
        .equ    n, 1
        .equ    p, 3
        .warm
        .data
a:      .word   1.0, 2.0, 3.0, 4.0
b:      .word   1.0, 10.0, -2.0
want_c: .word   1.0, 2.0, 3.0, 4.0
        .word   10.0, 20.0, 30.0, 40.0
        .word   -2.0, -4.0, -6.0, -8.0
