; test: ten elements: too few for a reduction
; tolerance: x 1e-9
        .equ    n, 10
        .warm
        .data

; a(i) goes through -0.9, -0.7, .. 0.9, but a(0) is 0; x(i) is to be i mod 7 - 3; so b(i) is
; x(i) - a(i) x(i - 1).
a:      .rept   n
        .word   (float(\+ % 10 * 2) - 9) / 10 * (\+ > 0)
        .endr
b:      .rept   n
        .word   float(\+ % 7 - 3) - (float(\+ % 10 * 2) - 9) / 10 * (\+ > 0) * ((\+ + 6) % 7 - 3)
        .endr
want_x: .rept   n
        .word   float(\+ % 7 - 3)
        .endr
