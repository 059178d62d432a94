; test: one point, in the last of five cells
; tolerance: y 1e-9
        .equ    n, 1
        .equ    m, 5
        .warm
        .data
cell:   .word   5
x:      .word   0.5
place:  .word   0
table:  .rept   m
        .word   \+ * 3.0, \+.0, 2.0, 0
        .endr
want_y: .word   14.5
