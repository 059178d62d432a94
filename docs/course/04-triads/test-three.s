; test: three points, one of them falling
; tolerance: v 1e-9
; tolerance: x 1e-9

        .warm
        .equ    n, 3
        .data
h:      .word   0.25
f:      .word   4.0, 0.0, -8.0
v:      .word   1.0, 3.0, 0.0
x:      .word   0.0, -1.0, 100.0
want_v: .word   2.0, 3.0, -2.0
want_x: .word   0.5, -0.25, 99.5
