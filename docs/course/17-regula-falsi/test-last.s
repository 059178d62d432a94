; test: 96 quartics, of which the last two are found last
; tolerance: root 2e-10
        .equ    n, 96
        .warm

; s - (i + 1) / 100, with either sign; the last two are 10^-12 - s^4 and s^4 - 16 x 10^-12.
        .data
k0:     .rept   n - 2
        .word   (2 * (\+ % 2) - 1) * (\+ + 1) / 100.0
        .endr
        .word   1e-12, -16e-12
k1:     .rept   n - 2
        .word   1.0 - 2 * (\+ % 2)
        .endr
        .word   0.0, 0.0
k2:     .rept   n
        .word   0.0
        .endr
k3:     .rept   n
        .word   0.0
        .endr
k4:     .rept   n - 2
        .word   0.0
        .endr
        .word   -1.0, 1.0
want_root:
        .rept   n - 2
        .word   (\+ + 1) / 100.0
        .endr
        .word   0.001, 0.002
