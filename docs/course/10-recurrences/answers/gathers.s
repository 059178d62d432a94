; gathers.s - cyclic reduction, with periodic gathers and scatters for every second element.

        .include "core.s"

        .ifndef n                       ; the tests define it
        .equ    n, 100
        .endif
        .equ    SHORT, 40               ; the scalar loop solves up to SHORT

        .data
a:      .rept   n
        .word   float(\+ % 5) / 8
        .endr
b:      .rept   n
        .word   1.0 - float(\+ % 5) / 8
        .endr
x:      .space  n

        .code

        .regs   r10, as, bs, xs, a_odd, a_even, b_odd, b_even, x_odd, x_before
        .regs   r20, two, second
        .regs   r30, i, one, count, left, right, last

        ES      one, 1
        ES      two, 2

; The scalar loop.  The first equation has no unknown before it: its a is not used.
        .macro  solve_short a, b, x, length
        EX      as, \a
        EX      bs, \b
        EX      xs, \x
        ES      count, \length
        ES      i, 0
        ES      last, 0
short\@:
        LOD     [as, i], left
        LOD     [bs, i], right
        MPYS    left, last, last
        ADDN    last, right, last
        STO     [xs, i], last
        IBXLT   i, one, count, short\@, i
        .endm

; The equations with odd numbers are reduced:
;   x(2k+1) = a(2k+1) a(2k) x(2k-1)  +  a(2k+1) b(2k) + b(2k+1)
; Those with even numbers are stored: x(2k) = a(2k) x(2k-1) + b(2k).
        .macro  solve a, b, x, length
        .if     (\length) <= SHORT
        solve_short \a, \b, \x, \length
        .else
        .data
        .vector half_a\@, (\length) / 2
        .vector half_b\@, (\length) / 2
        .vector even_a\@, (\length) - (\length) / 2
        .vector even_b\@, (\length) - (\length) / 2
before\@:
        .word   0
        .vector half_x\@, (\length) / 2
        .code
        descriptor as, \a, \length
        descriptor bs, \b, \length
        descriptor a_odd, half_a\@, (\length) / 2
        descriptor b_odd, half_b\@, (\length) / 2
        descriptor a_even, even_a\@, (\length) - (\length) / 2
        descriptor b_even, even_b\@, (\length) - (\length) / 2
        EX      second, \a + 64
        VGATHP  two, [second], [a_odd]
        VGATHP  two, [as], [a_even]
        EX      second, \b + 64
        VGATHP  two, [second], [b_odd]
        VGATHP  two, [bs], [b_even]
        descriptor x_odd, half_x\@, (\length) / 2
        MPYSV   [a_odd], [b_even], [x_odd]
        ADDNV   [x_odd], [b_odd], [b_odd]
        MPYSV   [a_odd], [a_even], [a_odd]

        solve   half_a\@, half_b\@, half_x\@, (\length) / 2

        descriptor a_even, even_a\@, (\length) - (\length) / 2
        descriptor b_even, even_b\@, (\length) - (\length) / 2
        descriptor x_before, before\@, (\length) - (\length) / 2
        descriptor x_odd, half_x\@, (\length) / 2
        descriptor xs, \x, \length
        MPYSV   [a_even], [x_before], [a_even]
        ADDNV   [a_even], [b_even], [a_even]
        EX      second, \x + 64
        VSCATP  two, [x_odd], [second]
        VSCATP  two, [a_even], [xs]
        .endif
        .endm

        .kernel recurrence
        solve   a, b, x, n
        .endkernel
        EXIT
; expect: [x] = 1.0, 1.0, 1.0 ~ 1e-9
; expect: [x + 64 * (n - 1)] = 1.0 ~ 1e-9
