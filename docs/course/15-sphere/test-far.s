; test: a small sphere far away, in which b^2 - L . L + r^2 would lose its digits
; tolerance: tin 1e-8
; tolerance: tout 1e-8
        .equ    n, 3
        .warm

; The sphere is 0.1 wide and 100,000 away; the rays pass the centre at 0.05 times 0, 0.6 and 0.8.
        .data
ox:     .word   0.0, 0.03, 0.04
oy:     .rept   3
        .word   0.0
        .endr
oz:     .rept   3
        .word   0.0
        .endr
dx:     .rept   3
        .word   0.0
        .endr
dy:     .rept   3
        .word   0.0
        .endr
dz:     .word   1.0, 1.0, 1.0
sphere: .word   0.0, 0.0, 100000.0, 0.0025
want_tin:
        .word   99999.95, 99999.96, 99999.97
want_tout:
        .word   100000.05, 100000.04, 100000.03
