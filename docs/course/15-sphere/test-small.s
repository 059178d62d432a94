; test-small.s
; test: five rays: through the centre, past it, at the rim, from inside, away from it
; tolerance: tin 1e-11
; tolerance: tout 1e-11
        .equ    n, 5
        .warm

        .data
ox:     .word   0.0, 0.0, 2.0, 0.0, 0.0
oy:     .word   1.0, 5.0, 1.0, 1.0, 1.0
oz:     .word   -10.0, -10.0, -10.0, 0.5, 10.0
dx:     .word   0.0, 0.0, 0.0, 0.6, 0.0
dy:     .space  5
dz:     .word   1.0, 1.0, 1.0, 0.8, 1.0
sphere: .word   0.0, 1.0, 0.0, 4.0
want_tin:
        .word   8.0, 1e30, 10.0, -0.4 - sqrt(3.91), -12.0
want_tout:
        .word   12.0, -1e30, 10.0, -0.4 + sqrt(3.91), -8.0
