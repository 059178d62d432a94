; test: points with known counts, some of them on the edge
; tolerance: counts 0.1
        .equ    n, 8
        .equ    most, 30
        .warm
        .data
cx:     .word   0.0, 1.0, -2.0, -1.0, 0.0, 0.5, 3.0, 0.0
cy:     .word   0.0, 0.0,  0.0,  0.0, 1.0, 0.0, 4.0, 2.5

; 0 stays, 1 comes to 2, -2 is on the circle, -1 and i stay on cycles, 0.5 needs 5 steps.
want_counts:
        .word   30, 2, 1, 30, 30, 5, 1, 1
want_total:
        .word   100.0
