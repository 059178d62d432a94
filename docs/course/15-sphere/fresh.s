; test: another number of rays
; tolerance: tin 1e-8
; tolerance: tout 1e-8

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 2 + draw % 80
        .endif

; As in test-queue.s, ray i starts at C - 10 D + (x, y, 0), and half of 2,000 rays hit.  The
; directions D are (0.48, 0.6, 0.64) with three orders of the numbers.
        .equ    offset, float(draw % 83) * 0.000417
        .equ    cx, float(draw % 13) - 6.25
        .equ    cy, float(draw % 11) - 5.125
        .equ    cz, float(draw % 7) + 3.5

        .macro  direction i
        .if     \i % 3 == 0
        .word   0.48
        .elseif \i % 3 == 1
        .word   0.6
        .else
        .word   0.64
        .endif
        .endm

        .macro  start i, c, offset
        .if     \i % 3 == 0
        .word   \c - 4.8 + \offset
        .elseif \i % 3 == 1
        .word   \c - 6.0 + \offset
        .else
        .word   \c - 6.4 + \offset
        .endif
        .endm

        .warm
        .data
ox:     .rept   n
        start   \+, cx, (((\+ * 733 + draw) % 2000 % 50 - 25) / 8.0 + offset)
        .endr
oy:     .rept   n
        start   (\+ + 1), cy, (((\+ * 733 + draw) % 2000 / 50 - 20) / 8.0 + offset)
        .endr
oz:     .rept   n
        start   (\+ + 2), cz, 0.0
        .endr
dx:     .rept   n
        direction \+
        .endr
dy:     .rept   n
        direction (\+ + 1)
        .endr
dz:     .rept   n
        direction (\+ + 2)
        .endr
sphere: .word   cx, cy, cz, 3.2 + float(draw % 31) / 256
want_tin:
        .space  n
want_tout:
        .space  n
