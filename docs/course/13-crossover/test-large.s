; test: 320 columns, most of them with 1 to 3 elements, ten with 100
; goals: gold 26000, silver 30500, bronze 39500
        .equ    n, 320
        .equ    m, 1614
        .warm

; Columns 0, 20 .. 180 have 100 elements; other columns j have 1 + j % 3, the last three none.
; The elements of row i are i % 8 / 8.
        .macro  column j
        .if     \j % 20 == 0 && \j < 200
        elements \j + 1, 100
        .elseif \j < n - 3
        elements \j + 1, 1 + \j % 3
        .endif
        .endm

        .macro  elements row, count
        .rept   \count
        .word   float((\row + \+) % 8) / 8
        .endr
        .endm

; x(j) = 1, so right-hand side i is 1 + i % 8 / 8 for each column that reaches row i: short ones
; from 1, 2 or 3 rows above, and long ones.
        .macro  right i
        .word   1 + float(\i % 8) / 8 * ((\i > 0 && \i < 318 && ((\i + 19) % 20 != 0 || \i > 200)) + (\i > 1 && \i < 319 && ((\i + 18) % 20 != 0 || \i > 201) && (\i + 1) % 3 > 0) + (\i > 2 && ((\i + 17) % 20 != 0 || \i > 202) && \i % 3 > 1) + (\i < 200) * ((\i + 19) / 20) + (\i >= 200) * 10 - (\i > 100) * ((\i - 81) / 20) + (\i > 280) * ((\i - 281) / 20))
        .endm

        .data
lengths:
        .rept   n
        .word   (\+ % 20 == 0 && \+ < 200) * 100 + ((\+ % 20 != 0 || \+ >= 200) && \+ < n - 3) * (1 + \+ % 3)
        .endr
l:      .rept   n
        column  \+
        .endr
x:      .rept   n
        right   \+
        .endr
want_x: .rept   n
        .word   1.0
        .endr
