; test-one.s
; test: queues of a single ray
; tolerance: depth 1e-8
        .equ    rays, 12
        .equ    queue, 1
        .equ    bodies, 3
        .warm

        .data
spheres:
        .word   0.15, 0.2, 5.0, 0.0225
        .word   0.5, 0.25, 4.0, 0.03
        .word   0.8, 0.2, 6.0, 0.035
want_seen:
        .word   4.0
want_depth:
        .word   21.60768031165
