; all-vectors.s - forward substitution with the columns of a profile matrix: all in
; vector form.

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
        .regs   r20, length, factor, below, column, handed, bits

        EX      length_at, lengths
        EX      l_at, l
        EX      x_at, x
        EX      columns, n
        EX      next_at, next
        ES      word, 64

        .kernel substitution
next:   LOD     [length_at], length
        LOD     [x_at], factor
        ADDX    length_at, word, length_at
        ADDX    x_at, word, x_at
        IBXEQ   length, r0, r0, done

        ADDLEN  l_at, length, column
        ADDLEN  x_at, length, below
        ADDLEN  x_at, length, handed    ; not stored
        LINKV
        MPYSV   [column], factor, [handed]
        SUBNV   [below], [handed], [below]
        SHIFTI  length, 6, bits
        ADDX    l_at, bits, l_at
done:   DBNZ    columns, [next_at]
        .endkernel
        EXIT
