; test: six quartics, of which one has its root at 1/2 exactly and one at 0
; tolerance: root 2e-10
        .equ    n, 6
        .warm

        .data
k0:     .word   -0.5, 1.0, 0.0, -0.0081, -1e-8, 0.0625
k1:     .word   1.0, -4.0, 0.0, 0.0, 0.0, 0.0
k2:     .word   0.0, 0.0, -1.0, 0.0, 0.0, 0.0
k3:     .word   0.0, 0.0, 0.0, 0.0, 0.0, 0.0
k4:     .word   0.0, 0.0, 0.0, 1.0, 1.0, -1.0
want_root:
        .word   0.5, 0.25, 0.0, 0.3, 0.01, 0.5
