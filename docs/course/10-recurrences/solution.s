; solution.s - x(i) = a(i) x(i - 1) + b(i), by cyclic reduction.
;
; Substituting each equation into the next one leaves a recurrence of every second unknown, of
; half the length.  It is solved in the same way; then vectors compute the other unknowns.

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

        .bitvector every_second, n      ; 0101..
        .code

        .regs   r10, as, bs, xs, a_odd, a_even, b_odd, b_even, x_odd, x_before
        .regs   r20, odd, zeros, group
        .regs   r30, i, one, count, left, right, last

        ES      one, 1
        ES      zeros, 1
        ES      group, 2
        descriptor odd, every_second, n
        MRKZ    zeros, group, [odd]

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
        ELEN    odd, \length
        CPSV    [as], [a_odd] ? [odd]
        CPSV    [as], [a_even] ?! [odd]
        CPSV    [bs], [b_odd] ? [odd]
        CPSV    [bs], [b_even] ?! [odd]
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
        MRGV    [x_odd], [a_even], [xs] ? [odd]
        .endif
        .endm

        .kernel recurrence
        solve   a, b, x, n
        .endkernel
        EXIT
; expect: [x] = 1.0, 1.0, 1.0 ~ 1e-9
; expect: [x + 64 * (n - 1)] = 1.0 ~ 1e-9
