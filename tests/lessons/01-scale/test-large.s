; test: ten thousand elements, in time
; goals: gold 25000, silver 40000, bronze 300000
        .equ    n, 10000
        .warm
        .data
x:
        .rept   n
        .word   \+ * 1.0
        .endr
want_y:
        .rept   n
        .word   \+ * 2.0
        .endr
want_above: .word n - 501
