; test: six rays: through the centre, past it, at the rim, from inside, away from it, aslant
; tolerance: tin 1e-11
; tolerance: tout 1e-11
        .equ    n, 6
        .warm

        .data
ox:     .word   0.0, 0.0, 2.0, 0.0, 0.0, -4.8
oy:     .word   1.0, 5.0, 1.0, 1.0, 1.0, -5.0
oz:     .word   -10.0, -10.0, -10.0, 0.5, 10.0, -6.4
dx:     .word   0.0, 0.0, 0.0, 0.6, 0.0, 0.48
dy:     .word   0.0, 0.0, 0.0, 0.0, 0.0, 0.6
dz:     .word   1.0, 1.0, 1.0, 0.8, 1.0, 0.64
sphere: .word   0.0, 1.0, 0.0, 4.0
tin:    .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
tout:   .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
want_tin:
        .word   8.0, 1e30, 10.0, -0.4 - sqrt(3.91), -12.0, 8.0
want_tout:
        .word   12.0, -1e30, 10.0, -0.4 + sqrt(3.91), -8.0, 12.0
