; start.s - forward substitution with the columns of a profile matrix: the loop over the
; columns is complete; the update of the rows below a column is missing.

        .include "core.s"

        .ifndef n
        .equ    n, 12                   ; columns
        .equ    m, 18                   ; elements of l
        .endif

        .data
lengths:
        .rept   n
        .word   (\+ + 4 <= n) * (1 + \+ % 3)
        .endr
l:      .rept   m
        .word   0.5
        .endr
x:      .rept   n
        .word   1.0 + \+
        .endr
        .code

        .regs   r10, length_at, l_at, x_at, columns, next_at, word
        .regs   r20, length, factor

        EX      length_at, lengths
        EX      l_at, l
        EX      x_at, x
        EX      columns, n
        EX      next_at, next
        ES      word, 64

        .kernel substitution
next:   LOD     [length_at], length     ; elements of this column
        LOD     [x_at], factor          ; x(j), now known
        ADDX    length_at, word, length_at
        ADDX    x_at, word, x_at        ; the row below

; your code here: subtract length elements from l_at on, times factor, from the words from
; x_at on.  Afterwards l_at points to the next column, and x_at is unchanged.

        DBNZ    columns, [next_at]
        .endkernel
        EXIT
