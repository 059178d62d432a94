; test: 1,000 points in 50 cells, in permuted order
; tolerance: y 1e-9
; goals: gold 7200, silver 7900, bronze 14000
        .equ    n, 1000
        .equ    m, 50
        .warm
        .data

; Point i lies in cell 7 i mod 50 at (i mod 64) / 64, its place is 7 i mod 1000: so the point
; of place j is 143 j mod 1000, and its cell, counted from 0, is j mod 50.
cell:   .rept   n
        .word   \+ * 7 % m + 1
        .endr
x:      .rept   n
        .word   float(\+ % 64) / 64
        .endr
place:  .rept   n
        .word   \+ * 7 % n
        .endr
table:  .rept   m
        .word   100.0 * \+, 5.0 - \+, 0.5 * \+, 0
        .endr
want_y: .rept   n
        .word   100.0 * (\+ % m) + float(\+ * 143 % n % 64) / 64 * (5.0 - \+ % m + float(\+ * 143 % n % 64) / 64 * 0.5 * (\+ % m))
        .endr
