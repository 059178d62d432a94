; test: 70 equations that are all found in the same step
; tolerance: root 2e-10
        .equ    n, 70
        .warm

        .data
k0:     .rept   n
        .word   0.75
        .endr
k1:     .rept   n
        .word   -1.0
        .endr
k2:     .rept   n
        .word   0.0
        .endr
k3:     .rept   n
        .word   0.0
        .endr
k4:     .rept   n
        .word   0.0
        .endr
want_root:
        .rept   n
        .word   0.75
        .endr
