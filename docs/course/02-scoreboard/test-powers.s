; test: coefficients 1 to 8 at x = 2
; tolerance: p 1e-9

        .warm
        .data
x:      .word   2.0
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0
want_p: .word   1793.0
