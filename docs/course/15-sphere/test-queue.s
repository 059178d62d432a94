; test: a queue of 2,000 rays, of which half hit
; tolerance: tin 1e-10
; tolerance: tout 1e-10
; goals: gold 26800, silver 30000, bronze 36000
        .equ    n, 2000
        .warm

; Ray i starts at (x, y, 0), x = (i % 50 - 25) / 8, y = (i / 50 - 20) / 8, in the direction
; D = (0.48, 0.6, 0.64); the sphere about 10 D has r^2 = 3.2.  So L = 10 D - (x, y, 0),
; b = 10 - p, w = (x, y, 0) - p D, h = r^2 - x^2 - y^2 + p^2, with p = 0.48 x + 0.6 y.
        .macro  distance x, y, side, miss
        along   \x, \y, (0.48 * \x + 0.6 * \y), \side, \miss
        .endm

        .macro  along x, y, p, side, miss
        .if     3.2 - \x * \x - \y * \y + \p * \p >= 0
        .word   10 - \p + \side * sqrt(3.2 - \x * \x - \y * \y + \p * \p)
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
oz:     .rept   n
        .word   0.0
        .endr
dx:     .rept   n
        .word   0.48
        .endr
dy:     .rept   n
        .word   0.6
        .endr
dz:     .rept   n
        .word   0.64
        .endr
sphere: .word   4.8, 6.0, 6.4, 3.2
want_tin:
        .rept   n
        distance ((\+ % 50 - 25) / 8.0), ((\+ / 50 - 20) / 8.0), -1.0, 1e30
        .endr
want_tout:
        .rept   n
        distance ((\+ % 50 - 25) / 8.0), ((\+ / 50 - 20) / 8.0), 1.0, -1e30
        .endr
