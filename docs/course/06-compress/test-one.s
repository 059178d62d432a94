; test: a single equation, and it has a root
; tolerance: t 1e-9

        .warm
        .equ    n, 1
        .data
a:      .word   2.0
b:      .word   5.0
d:      .word   9.0
want_t: .word   1.0
want_hits:
        .word   1
