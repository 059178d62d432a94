; test: at x = 0, where only a0 is left
; tolerance: p 1e-9

        .warm
        .data
x:      .word   0.0
a:      .word   -3.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0
want_p: .word   -3.5
