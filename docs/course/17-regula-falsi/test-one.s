; test: a single quartic
; tolerance: root 2e-10
        .equ    n, 1
        .warm

        .data
k0:     .word   -0.4096
k1:     .word   0.0
k2:     .word   0.0
k3:     .word   0.0
k4:     .word   1.0
want_root:
        .word   0.8
