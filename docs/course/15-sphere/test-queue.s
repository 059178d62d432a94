; test-queue.s
; test: a queue of 2,000 rays, of which half hit
; tolerance: tin 1e-10
; tolerance: tout 1e-10
; goals: gold 26800, silver 30000, bronze 36000
        .equ    n, 2000
        .warm

; Ray i starts at (x, y, 0), x = (i % 50 - 25) / 8, y = (i / 50 - 20) / 8, in the direction
; (3/5, 0, 4/5); the sphere about (6, 0, 8) has r^2 = 4.03.  So L = (6 - x, -y, 8),
; b = 10 - 3/5 x, w = b D - L = (16/25 x, y, -12/25 x), h = r^2 - 16/25 x^2 - y^2.
        .macro  distance x, y, side, miss
        .if     4.03 - 0.64 * \x * \x - \y * \y >= 0
        .word   10 - 0.6 * \x + \side * sqrt(4.03 - 0.64 * \x * \x - \y * \y)
        .else
        .word   \miss
        .endif
        .endm

        .data
ox:     .rept   n
        .word   (\+ % 50 - 25) / 8.0
        .endr
oy:     .rept   n
        .word   (\+ / 50 - 20) / 8.0
        .endr
oz:     .space  n
dx:     .rept   n
        .word   0.6
        .endr
dy:     .space  n
dz:     .rept   n
        .word   0.8
        .endr
sphere: .word   6.0, 0.0, 8.0, 4.03
want_tin:
        .rept   n
        distance ((\+ % 50 - 25) / 8.0), ((\+ / 50 - 20) / 8.0), -1.0, 1e30
        .endr
want_tout:
        .rept   n
        distance ((\+ % 50 - 25) / 8.0), ((\+ / 50 - 20) / 8.0), 1.0, -1e30
        .endr
