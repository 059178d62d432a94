; test: 30 rays and 3 spheres in queues of 7, the last of 2
; tolerance: depth 1e-8
        .equ    rays, 30
        .equ    queue, 7
        .equ    bodies, 3
        .warm

        .data
spheres:
        .word   0.15, 0.2, 5.0, 0.0225
        .word   0.5, 0.25, 4.0, 0.03
        .word   0.8, 0.2, 6.0, 0.035
want_seen:
        .word   9.0
want_depth:
        .word   44.10349102583
