; test: 20 frames of 300 numbers, which come from disc
; tolerance: mean 1e-9
; goals: gold 34700, silver 38000, bronze 54000
        .equ    n, 300

; Number i of frame k is 1000 or so with a square, where i is odd, or a peak, where it is even,
; upside down for every third i; these begin at another frame for each i.
        .macro  number i, k
        .if     \i % 2
        .word   1000 + (2 * (\i % 3 > 0) - 1) * float((\k + \i) % 20 * ((\k + \i) % 20))
        .else
        .word   1000 + (2 * (\i % 3 > 0) - 1) * float((\k + \i) % 10 == 9)
        .endif
        .endm

        .macro  frame k
        .rept   n
        number  \+, \k
        .endr
        .space  65536 - n
        .endm

        .data
frames: .rept   20
        frame   \+
        .endr
want_mean:
        .rept   n
        .word   1000 + (2 * (\+ % 3 > 0) - 1) * (\+ % 2 * 123.5 + (\+ + 1) % 2 * 0.1)
        .endr
want_above:
        .rept   n
        .word   float(\+ % 2 * (8 + 4 * (\+ % 3 == 0)) + (\+ + 1) % 2 * (2 + 16 * (\+ % 3 == 0)))
        .endr
