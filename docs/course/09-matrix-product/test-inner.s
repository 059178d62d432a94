; test: one row times one column: c is one number
; tolerance: c 1e-9
        .equ    m, 1
        .equ    n, 5
        .equ    p, 1
        .warm
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0
b:      .word   1.0, -1.0, 1.0, -1.0, 2.0
want_c: .word   8.0
