; test: 100,000 rays and 8 spheres, with the paper's queue of 2,000
; tolerance: depth 0.001
; goals: gold 3110000, silver 6200000, bronze 11500000
        .equ    rays, 100000
        .equ    queue, 2000
        .equ    bodies, 8
        .warm

        .data
spheres:
        .word   0.15, 0.2, 5.0, 0.0225
        .word   0.5, 0.25, 4.0, 0.03
        .word   0.8, 0.2, 6.0, 0.035
        .word   0.2, 0.6, 3.0, 0.025
        .word   0.5, 0.55, 7.0, 0.04
        .word   0.85, 0.6, 4.5, 0.02
        .word   0.35, 0.85, 5.5, 0.0225
        .word   0.7, 0.8, 6.5, 0.03
want_seen:
        .word   66435.0
want_depth:
        .word   342858.766032
