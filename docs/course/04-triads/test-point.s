; test: a single point
; tolerance: v 1e-9
; tolerance: x 1e-9

        .warm
        .equ    n, 1
        .data
h:      .word   2.0
f:      .word   1.0
v:      .word   -1.0
x:      .word   5.0
want_v: .word   1.0
want_x: .word   7.0
