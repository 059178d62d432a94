; solution.s - forward substitution with the columns of a profile matrix: short columns in
; a scalar loop, three elements at a time, long ones in vector form.

        .include "core.s"

        .ifndef n
        .equ    n, 12                   ; columns
        .equ    m, 18                   ; elements of l
        .endif
        .equ    CROSSOVER, 10           ; the least length at which vectors are faster

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
        .space  2                       ; three elements are read even if there is one
        .code

        .regs   r10, length_at, l_at, x_at, columns, next_at, one, two, three, word, triple
        .regs   r20, length, factor, below, column, handed, bits, crossover
        .regs   r30, l0, l1, l2, x0, x1, x2

        EX      length_at, lengths
        EX      l_at, l
        EX      x_at, x
        EX      columns, n
        EX      next_at, next
        ES      one, 1
        ES      two, 2
        ES      three, 3
        ES      word, 64
        ES      triple, 3 * 64
        ES      crossover, CROSSOVER

        .kernel substitution
next:   LOD     [length_at], length
        LOD     [x_at], factor
        ADDX    length_at, word, length_at
        ADDX    x_at, word, x_at
        RTOR    x_at, below
        IBXEQ   length, r0, r0, done
        IBXGE   length, r0, crossover, long

; Six loads may be pending.
short:  LOD     [l_at], l0
        LOD     [below], x0
        LOD     [l_at, one], l1
        LOD     [below, one], x1
        LOD     [l_at, two], l2
        LOD     [below, two], x2
        MPYS    l0, factor, l0
        MPYS    l1, factor, l1
        MPYS    l2, factor, l2
        SUBN    x0, l0, x0
        SUBN    x1, l1, x1
        SUBN    x2, l2, x2
        STO     [below], x0
        IBXEQ   length, r0, one, last
        STO     [below, one], x1
        IBXEQ   length, r0, two, last
        STO     [below, two], x2
        ADDX    l_at, triple, l_at
        ADDX    below, triple, below
        SUBX    length, three, length
        IBXNE   length, r0, r0, short
        DBNZ    columns, [next_at]
        EXIT
last:   SHIFTI  length, 6, bits
        ADDX    l_at, bits, l_at
        DBNZ    columns, [next_at]
        EXIT

long:   ADDLEN  l_at, length, column
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
