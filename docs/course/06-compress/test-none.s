; test: no equation has a root
; tolerance: t 1e-9

        .warm
        .equ    n, 3
        .data
a:      .word   1.0, 1.0, 2.0
b:      .word   5.0, 7.0, 3.0
d:      .word   -9.0, -4.0, -1.0
want_t: .word   -1.0, -1.0, -1.0
want_hits:
        .word   0
