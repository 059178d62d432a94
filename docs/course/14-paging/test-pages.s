; test: 20 frames of 300 numbers, not in memory at the start
; tolerance: mean 1e-9
; goals: gold 34700, silver 38000, bronze 54000
        .equ    n, 300

; Number i of frame k is 1000 plus a term, or minus it for every third i.  The term is the square
; of (k + i) mod 20 for odd i, and for even i it is 1 in every tenth frame, else 0.
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
