; test: 6,000 equations, one in six with a root
; tolerance: t 1e-9
; goals: gold 19000, silver 21000, bronze 450000

        .warm
        .equ    n, 6000
        .data
a:
        .rept   n
        .word   1.0 + 0.5 * float(\+ % 3)
        .endr
b:
        .rept   n
        .word   20.0 + float(\+ % 7)
        .endr
d:
        .rept   n
        .if     \+ * 5 % 6 == 0
        .word   float((\+ % 11) * (\+ % 11))
        .else
        .word   -1.0 - float(\+ % 5)
        .endif
        .endr
want_t:
        .rept   n
        .if     \+ * 5 % 6 == 0
        .word   (20.0 + float(\+ % 7) - float(\+ % 11)) / (1.0 + 0.5 * float(\+ % 3))
        .else
        .word   -1.0
        .endif
        .endr
want_hits:
        .word   1000
