; test: another number of columns
; tolerance: x 1e-9

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 4 + draw % 200
        .endif

; As in test-large.s, one column in 20 is long and the others have 1 to 3 elements.  No column
; is longer than the rows below it.
        .equ    long, (n > 220) * 100 + (n <= 220) * 12
        .equ    first, draw % 20

        .macro  column j
        .if     \j % 20 == first && \j + long < n && \j < 200
        .rept   long
        .word   float((\+ * 7 + \j * 3 + draw) % 17 - 8) / 128
        .endr
        .elseif \j < n - 3
        .rept   1 + (\j + draw) % 3
        .word   float((\+ * 5 + \j * 11 + draw) % 15 - 7) / 64
        .endr
        .endif
        .endm

        .warm
        .data
lengths:
        .rept   n
        .if     \+ % 20 == first && \+ + long < n && \+ < 200
        .word   long
        .elseif \+ < n - 3
        .word   1 + (\+ + draw) % 3
        .else
        .word   0
        .endif
        .endr
l:      .rept   n
        column  \+
        .endr
l_end:
        .equ    elements, (l_end - l) / 64
        .equ    m, elements + (elements == 0)
x:      .rept   n
        .word   float((\+ * 37 + draw * 5) % 201 - 100) / 4
        .endr
want_x: .space  n
