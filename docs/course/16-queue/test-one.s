; test: queues of a single ray, the first of which touches a sphere
; tolerance: depth 1e-8
        .equ    rays, 12
        .equ    queue, 1
        .equ    bodies, 4
        .warm

        .data
spheres:
        .word   0.15, 0.2, 5.0, 0.0225
        .word   0.5, 0.25, 4.0, 0.03
        .word   0.8, 0.2, 6.0, 0.035
        .word   0.5, 0.0, 3.0, 0.25
want_seen:
        .word   6.0
want_depth:
        .word   19.81950196851
