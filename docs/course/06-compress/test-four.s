; test: four equations, one without a root, one with a double root
; tolerance: t 1e-9

        .warm
        .equ    n, 4
        .data
a:      .word   1.0, 1.0, 2.0, 4.0
b:      .word   5.0, 7.0, 3.0, 8.0
d:      .word   9.0, -4.0, 0.0, 16.0
want_t: .word   2.0, -1.0, 1.5, 1.0
want_hits:
        .word   3
