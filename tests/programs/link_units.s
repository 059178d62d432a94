; Linked pairs of every two units: add, multiply, divide, shift, logical.

        .include "vector.inc"

        .regs   r40, t, p, q, bit, mask

        .data
a:      .word   4.0, 9.0, 16.0
b:      .word   2.0, 3.0, -4.0
ones:   .word   1, 2, 3
tens:   .word   10, 20, 30
two:    .word   2.0
        .code
        descriptor va, a, 3
        descriptor vb, b, 3
        descriptor p, ones, 3
        descriptor q, tens, 3
        descriptor t, 0, 3              ; what is handed over lies nowhere
        load    x, two
        ES      bit, 1
        ES      mask, 15

; Add first.  Integers are added as integers.
        into    add_multiply, 3
        LINKV
        ADDNV   [va], [vb], [t]
        MPYSV   [t], x, [to]
; expect: [add_multiply] = 12.0, 24.0, 24.0
        into    add_divide, 3
        LINKV
        SUBNV   [va], [vb], [t]
        DIVSV   [t], x, [to]
; expect: [add_divide] = 1.0, 3.0, 10.0
        into    add_shift, 3
        LINKV
        ADDXV   [p], [q], [t]
        SHIFTV  [t], bit, [to]
; expect: [add_shift] = 22, 44, 66
        into    add_logical, 3
        LINKV
        ADDXV   [p], [q], [t]
        ANDV    [t], mask, [to]
; expect: [add_logical] = 11, 6, 1

; Multiply first.  A number that is shifted left by one has twice its exponent, and
; the sign of that behind its last digit.
        into    multiply_add, 3
        LINKV
        MPYSV   [va], x, [t]
        SUBNV   [vb], [t], [to]
; expect: [multiply_add] = -6.0, -15.0, -36.0
        into    multiply_divide, 3
        LINKV
        MPYSV   [va], x, [t]
        DIVSV   [t], [vb], [to]
; expect: [multiply_divide] = 4.0, 6.0, -8.0
        into    multiply_shift, 3
        LINKV
        MPYSV   [va], x, [t]
        SHIFTV  [t], bit, [to]
; expect: [multiply_shift] = X'FFAA 8000 0000 0001', X'FFAC 9000 0000 0001'
; expect: [multiply_shift + 2*64] = X'FFAE 8000 0000 0001'
        into    multiply_logical, 3
        LINKV
        MPYSV   [va], x, [t]
        ORV     [t], mask, [to]
; expect: [multiply_logical] = X'FFD5 4000 0000 000F', X'FFD6 4800 0000 000F'
; expect: [multiply_logical + 2*64] = X'FFD7 4000 0000 000F'

; Divide first, or take roots.
        into    divide_add, 3
        LINKV
        DIVSV   [va], x, [t]
        ADDNV   [t], [vb], [to]
; expect: [divide_add] = 4.0, 7.5, 4.0
        into    divide_multiply, 3
        LINKV
        DIVSV   [va], [vb], [t]
        MPYSV   x, [t], [to]
; expect: [divide_multiply] = 4.0, 6.0, -8.0
        into    divide_shift, 3
        LINKV
        SQRTV   [va], [t]
        SHIFTV  [t], bit, [to]
; expect: [divide_shift] = X'FFA6 8000 0000 0001', X'FFA6 C000 0000 0001'
; expect: [divide_shift + 2*64] = X'FFA8 8000 0000 0001'
        into    divide_logical, 3
        LINKV
        SQRTV   [va], [t]
        ORV     mask, [t], [to]
; expect: [divide_logical] = X'FFD3 4000 0000 000F', X'FFD3 6000 0000 000F'
; expect: [divide_logical + 2*64] = X'FFD4 4000 0000 000F'

; Shift first.  2, 4 and 6 have 2 and 3 significant bits.
        into    shift_add, 3
        LINKV
        SHIFTV  [p], bit, [t]
        ADDXV   [t], [q], [to]
; expect: [shift_add] = 12, 24, 36
        into    shift_multiply, 3
        LINKV
        SHIFTV  [p], bit, [t]
        MPYSV   [t], [vb], [to]
; expect: [shift_multiply] = 4.0, 12.0, -24.0 ~ 0
        into    shift_divide, 3
        LINKV
        SHIFTV  [p], bit, [t]
        DIVSV   [t], x, [to]
; expect: [shift_divide] = 1.0, 2.0, 3.0 ~ 0
        into    shift_logical, 3
        LINKV
        SHIFTV  [p], bit, [t]
        XORV    [t], [q], [to]
; expect: [shift_logical] = 8, 16, 24

; A logical one first.
        into    logical_add, 3
        LINKV
        ORV     [p], mask, [t]
        ADDXV   [t], [q], [to]
; expect: [logical_add] = 25, 35, 45
        into    logical_multiply, 3
        LINKV
        XORV    [va], r0, [t]
        MPYSV   [t], [vb], [to]
; expect: [logical_multiply] = 8.0, 27.0, -64.0
        into    logical_divide, 3
        LINKV
        XORV    [va], r0, [t]
        SQRTV   [t], [to]
; expect: [logical_divide] = 2.0, 3.0, 4.0
        into    logical_shift, 3
        LINKV
        XORV    [p], [q], [t]
        SHIFTV  [t], bit, [to]
; expect: [logical_shift] = 22, 44, 58

; One that has one source hands over, too; the signs are those of the second.
        into    unary, 3
        LINKV
        FLRV    [va], [t]
        MPYSV   -[t], x, [to]
; expect: [unary] = -8.0, -18.0, -32.0 ~ 0

; What the first raises counts, also where the second holds the element back.
        .data
        .bitvector none, 3, "000"
zeros:  .word   1.0, 0.0, 1.0
        .code
        descriptor vz, none, 3
        descriptor va, zeros, 3
        into    held_back, 3
        LINKV
        DIVSV   x, [va], [t]            ; flags 41 and 46
        ADDNV   [t], [vb], [to] ? [vz]
; expect: [held_back] = 9.0, 9.0, 9.0

        EXIT
; expect-flags: X'0000 0000 0042 0000'
