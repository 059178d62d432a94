; test: a single point

        .warm
        .equ    n, 1
        .data
h:      .word   2.0
f:      .word   1.0
v:      .word   -1.0
x:      .word   5.0
want_v: .word   1.0
want_x: .word   7.0
