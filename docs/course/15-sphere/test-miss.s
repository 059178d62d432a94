; test: a single ray, which misses
        .equ    n, 1
        .warm

        .data
ox:     .word   0.0
oy:     .word   3.0
oz:     .word   0.0
dx:     .word   1.0
dy:     .word   0.0
dz:     .word   0.0
sphere: .word   5.0, 0.0, 0.0, 4.0
want_tin:
        .word   1e30
want_tout:
        .word   -1e30
