; Linked pairs of every two units are compared with results worked out by hand.
; A rejected pair, or exchanged operands, makes one differ.
; The units are: add, multiply, divide, shift, logical.

        .include "vector.inc"

; Runs a linked pair; the name states the number of sources of both instructions.
        .macro  link_two_two name, first, a, b, second, c, d
        into    \name, 3
        LINKV
        \first  \a, \b, [t]
        \second \c, \d, [to]
        .endm

        .macro  link_one_two name, first, a, second, c, d
        into    \name, 3
        LINKV
        \first  \a, [t]
        \second \c, \d, [to]
        .endm

        .macro  link_two_one name, first, a, b, second, c
        into    \name, 3
        LINKV
        \first  \a, \b, [t]
        \second \c, [to]
        .endm

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
        descriptor t, 0, 3              ; the handed-over vector is not in memory
        load    x, two
        ES      bit, 1
        ES      mask, 15
; The first instruction adds.  Integers are added as integers.
        link_two_two add_multiply, ADDNV, [va], [vb], MPYSV, [t], x
; expect: [add_multiply] = 12.0, 24.0, 24.0
        link_two_two add_divide, SUBNV, [va], [vb], DIVSV, [t], x
; expect: [add_divide] = 1.0, 3.0, 10.0
        link_two_two add_shift, ADDXV, [p], [q], SHIFTV, [t], bit
; expect: [add_shift] = 22, 44, 66
        link_two_two add_logical, ADDXV, [p], [q], ANDV, [t], mask
; expect: [add_logical] = 11, 6, 1
; The first instruction multiplies.  SHIFTV by one doubles the exponent and moves the
; sign bit of the word to its last bit.
        link_two_two multiply_add, MPYSV, [va], x, SUBNV, [vb], [t]
; expect: [multiply_add] = -6.0, -15.0, -36.0
        link_two_two multiply_divide, MPYSV, [va], x, DIVSV, [t], [vb]
; expect: [multiply_divide] = 4.0, 6.0, -8.0
        link_two_two multiply_shift, MPYSV, [va], x, SHIFTV, [t], bit
; expect: [multiply_shift] = X'FFAA 8000 0000 0001', X'FFAC 9000 0000 0001'
; expect: [multiply_shift + 2*64] = X'FFAE 8000 0000 0001'
        link_two_two multiply_logical, MPYSV, [va], x, ORV, [t], mask
; expect: [multiply_logical] = X'FFD5 4000 0000 000F', X'FFD6 4800 0000 000F'
; expect: [multiply_logical + 2*64] = X'FFD7 4000 0000 000F'
; The first instruction divides or takes roots.
        link_two_two divide_add, DIVSV, [va], x, ADDNV, [t], [vb]
; expect: [divide_add] = 4.0, 7.5, 4.0
        link_two_two divide_multiply, DIVSV, [va], [vb], MPYSV, x, [t]
; expect: [divide_multiply] = 4.0, 6.0, -8.0
        link_one_two divide_shift, SQRTV, [va], SHIFTV, [t], bit
; expect: [divide_shift] = X'FFA6800000000001', X'FFA6C00000000001', X'FFA8800000000001'
        link_one_two divide_logical, SQRTV, [va], ORV, mask, [t]
; expect: [divide_logical] = X'FFD3 4000 0000 000F', X'FFD3 6000 0000 000F'
; expect: [divide_logical + 2*64] = X'FFD4 4000 0000 000F'
; The first instruction shifts.  2, 4 and 6 have 2 and 3 significant bits.
        link_two_two shift_add, SHIFTV, [p], bit, ADDXV, [t], [q]
; expect: [shift_add] = 12, 24, 36
        link_two_two shift_multiply, SHIFTV, [p], bit, MPYSV, [t], [vb]
; expect: [shift_multiply] = 4.0, 12.0, -24.0 ~ 0
        link_two_two shift_divide, SHIFTV, [p], bit, DIVSV, [t], x
; expect: [shift_divide] = 1.0, 2.0, 3.0 ~ 0
        link_two_two shift_logical, SHIFTV, [p], bit, XORV, [t], [q]
; expect: [shift_logical] = 8, 16, 24
; The first instruction is a logical one.
        link_two_two logical_add, ORV, [p], mask, ADDXV, [t], [q]
; expect: [logical_add] = 25, 35, 45
        link_two_two logical_multiply, XORV, [va], r0, MPYSV, [t], [vb]
; expect: [logical_multiply] = 8.0, 27.0, -64.0
        link_two_one logical_divide, XORV, [va], r0, SQRTV, [t]
; expect: [logical_divide] = 2.0, 3.0, 4.0
        link_two_two logical_shift, XORV, [p], [q], SHIFTV, [t], bit
; expect: [logical_shift] = 22, 44, 58
; The first instruction may have one source; sign control belongs to the second.
        link_one_two unary, FLRV, [va], MPYSV, -[t], x
; expect: [unary] = -8.0, -18.0, -32.0 ~ 0
; Data flags of the first are set even where the control vector masks the second.
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
