; test: another queue
; tolerance: depth 1e-8

        .ifdef  test_rays
        .equ    rays, test_rays
        .equ    queue, test_queue
        .equ    bodies, test_bodies
        .else
        .equ    rays, 20 + draw % 400
        .equ    queue, 1 + draw % 90
        .equ    bodies, 1 + draw % 7
        .endif

; The spheres are near those of test-paper.s, and the first is in the middle.
        .warm
        .data
spheres:
        .rept   bodies
        .word   float((\+ * 3 + 4) % 9) / 8 * 0.8 + 0.1 + float(draw * 7 % 97) / 2000
        .word   float((\+ * 5 + 4) % 9) / 8 * 0.8 + 0.1 + float(draw * 5 % 89) / 2000
        .word   3.0 + float((\+ * 7 + draw) % 31) / 8
        .word   0.0225 + float((\+ * 3 + draw) % 23) / 1024
        .endr
want_seen:
        .space  1
want_depth:
        .space  1
