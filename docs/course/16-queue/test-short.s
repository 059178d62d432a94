; test: a queue that is never full
; tolerance: depth 1e-8
        .equ    rays, 100
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
        .word   72.0
want_depth:
        .word   375.9188385808
