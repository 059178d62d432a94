; test: 2,000 quartics, most of which need few steps and some many
; tolerance: root 2e-10
; goals: gold 325000, silver 350000, bronze 465000
        .equ    n, 2000
        .warm

; Quartic i has the root a = (i % 97 + 1) / 100.  Every tenth is s^4 - a^4, the others are
; (s - a) (s^3 + s / 4 + r), r = (1 + i % 7) / 8.

        .macro  coefficient i, slow, fast
        .if     \i % 10 == 0
        .word   \slow
        .else
        .word   \fast
        .endif
        .endm

        .data
k0:     .rept   n
        coefficient \+, -power((\+ % 97 + 1) / 100.0, 4), -(\+ % 97 + 1) / 100.0 * ((1 + \+ % 7) / 8.0)
        .endr
k1:     .rept   n
        coefficient \+, 0.0, (1 + \+ % 7) / 8.0 - (\+ % 97 + 1) / 400.0
        .endr
k2:     .rept   n
        coefficient \+, 0.0, 0.25
        .endr
k3:     .rept   n
        coefficient \+, 0.0, -(\+ % 97 + 1) / 100.0
        .endr
k4:     .rept   n
        .word   1.0
        .endr
want_root:
        .rept   n
        .word   (\+ % 97 + 1) / 100.0
        .endr
