; test: three rows, two columns; c is not zero before
; tolerance: c 1e-9
        .equ    m, 3
        .equ    n, 2
        .equ    p, 2
        .warm
        .data
a:      .word   1.0, 0.0, -2.0
        .word   3.0, 0.5, 4.0
b:      .word   2.0, 1.0
        .word   -1.0, 10.0
c:      .word   7.0, 7.0, 7.0, 7.0, 7.0, 7.0
want_c: .word   5.0, 0.5, 0.0
        .word   29.0, 5.0, 42.0
