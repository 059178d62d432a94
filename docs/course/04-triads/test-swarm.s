; test: 2,000 points
; tolerance: v 1e-9
; tolerance: x 1e-9
; goals: gold 2260, silver 3300, bronze 100000

        .warm
        .equ    n, 2000
        .data
h:      .word   0.125
f:
        .rept   n
        .word   float(\+ * 3 % 101) - 50.0
        .endr
v:
        .rept   n
        .word   float(\+ % 17)
        .endr
x:
        .rept   n
        .word   float(\+)
        .endr
want_v:
        .rept   n
        .word   float(\+ % 17) + 0.125 * (float(\+ * 3 % 101) - 50.0)
        .endr
want_x:
        .rept   n
        .word   float(\+) + 0.125 * (float(\+ % 17) + 0.125 * (float(\+ * 3 % 101) - 50.0))
        .endr
