; test: six points in three cells, stored in reverse order
; tolerance: y 1e-9
        .equ    n, 6
        .equ    m, 3
        .warm
        .data
cell:   .word   2, 3, 1, 1, 3, 2
x:      .word   0.5, 0.0, 0.25, 0.75, 0.5, 0.25
place:  .word   5, 4, 3, 2, 1, 0
table:  .word   1.0, 2.0, 4.0, 0
        .word   10.0, -8.0, 16.0, 0
        .word   100.0, 0.0, -4.0, 0
y:      .space  6
want_y: .word   9.0, 99.0, 4.75, 1.75, 100.0, 10.0
