; test: other coefficients and another x
; tolerance: p 1e-9

        .warm
        .data
x:      .word   float(draw * 37 % 251 - 125) / 64
a:      .rept   8
        .word   float((draw * 101 + \+ * \+ * 31 + \+ * 57) % 127 - 63) / 8
        .endr
want_p: .space  1
