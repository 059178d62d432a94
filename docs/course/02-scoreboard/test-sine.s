; test: the first terms of the sine, at 0.5
; tolerance: p 1e-6
; goals: gold 62, silver 95, bronze 210

        .warm
        .data
x:      .word   0.5
a:      .word   0.0, 1.0, 0.0, -1.0 / 6, 0.0, 1.0 / 120, 0.0, -1.0 / 5040
want_p: .word   sin(0.5)
