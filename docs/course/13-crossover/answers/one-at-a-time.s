; one-at-a-time.s - forward substitution with the columns of a profile matrix: a
; loop over single elements.

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

        .regs   r10, length_at, l_at, x_at, columns, next_at, short_at, word
        .regs   r20, length, factor, below, left, value, product

        EX      length_at, lengths
        EX      l_at, l
        EX      x_at, x
        EX      columns, n
        EX      next_at, next
        ES      word, 64
        EX      short_at, short

        .kernel substitution
next:   LOD     [length_at], length
        LOD     [x_at], factor
        ADDX    length_at, word, length_at
        ADDX    x_at, word, x_at
        IBXEQ   length, r0, r0, done

        RTOR    x_at, below
short:  LOD     [l_at], left
        LOD     [below], value
        ADDX    l_at, word, l_at
        MPYS    left, factor, product
        SUBN    value, product, value
        STO     [below], value
        ADDX    below, word, below
        DBNZ    length, [short_at]
done:   DBNZ    columns, [next_at]
        .endkernel
        EXIT
