; test-turn.s
; test: 96 quartics, of which the first is found last
; tolerance: root 2e-10
        .equ    n, 96
        .warm

; The first is s^4 - 10^-12; the others are s - (i + 1) / 100, with either sign.
        .data
k0:     .word   -1e-12
        .rept   n - 1
        .word   (2 * (\+ % 2) - 1) * (\+ + 2) / 100.0
        .endr
k1:     .word   0.0
        .rept   n - 1
        .word   1.0 - 2 * (\+ % 2)
        .endr
k2:     .space  n
k3:     .space  n
k4:     .word   1.0
        .space  n - 1
want_root:
        .word   0.001
        .rept   n - 1
        .word   (\+ + 2) / 100.0
        .endr
