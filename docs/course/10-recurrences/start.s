; start.s - x(i) = a(i) x(i - 1) + b(i), by cyclic reduction.

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

; The scalar loop.
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

; The recurrence of the labels a, b and x, with that many elements.
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
        .word   0                       ; the element before the first x
        .vector half_x\@, (\length) / 2
        .code
        descriptor as, \a, \length
        descriptor bs, \b, \length
        ELEN    odd, \length
; your code here: half_a and half_b, the recurrence of the odd elements; keep what you
; need for the even ones in even_a and even_b

        solve   half_a\@, half_b\@, half_x\@, (\length) / 2

        descriptor xs, \x, \length
; your code here: the even elements, and all of x
        .endif
        .endm

        .kernel recurrence
        solve   a, b, x, n
        .endkernel
        EXIT
; expect: [x] = 1.0, 1.0, 1.0 ~ 1e-9
; expect: [x + 64 * (n - 1)] = 1.0 ~ 1e-9
