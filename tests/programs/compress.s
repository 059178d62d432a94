; The kept elements, their number and the bits that select them are compared with
; results worked out by hand, for every use.  A missing or additional element, a wrong
; length, or a bit outside the result makes a word differ.
; tests: CPSV ACPSV
; warns: zero-length ACPSV

        .include "vector.inc"

        .regs   r200, ones, zeros, empty, moved, scalar, zero_bits, short, in_place
        .regs   r208, room, kept, one_kept, none_kept, order

; CPSV: C := elements of A where Z has ones; length of C := number of ones in Z
        .data
CPSV.a: .word   1.0, 2.0, X'7ABC 0123 4567 89AB', 4.0, 5.0, 6.0
CPSV.scalars:
        .word   8.0, -0.5
        .bitvector CPSV.second, n, "010000"
        .bitvector CPSV.none, n, "000000"
CPSV.place0: .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        operands CPSV.
        into    CPSV.plain, 0                ; the length is that of Z
        CPSV    [va], [to] ? [vz]
        LTOR    to, ones
; expect: [CPSV.plain] = 1.0, X'7ABC 0123 4567 89AB', 4.0, 9.0, 9.0, 9.0
        register_is CPSV, ones, 3
        into    CPSV.where_zeros, 2          ; the length of C is ignored
        CPSV    [va], [to] ?! [vz]
        LTOR    to, zeros
; expect: [CPSV.where_zeros] = 2.0, 5.0, 6.0, 9.0, 9.0, 9.0
        register_is CPSV, zeros, 3
        of_one  CPSV, broadcast, x, [to] ? [vz]
        LTOR    to, scalar
; expect: [CPSV.broadcast] = 8.0, 8.0, 8.0, 9.0, 9.0, 9.0
        register_is CPSV, scalar, 3
        of_one  CPSV, offset_source, [va, twice], [to] ? [vz]
; expect: [CPSV.offset_source] = X'7ABC 0123 4567 89AB', 5.0, 6.0, 9.0, 9.0, 9.0
        of_one  CPSV, short_source, [short_a], [to] ?! [vz] ; padded with machine zeros
        LTOR    to, short
; expect: [CPSV.short_source] = 2.0, 0.0, 0.0, 9.0, 9.0, 9.0
        register_is CPSV, short, 3
; Z has no ones: the address of C stays and its length is 0
        descriptor vz, CPSV.none, n
        of_one  CPSV, nothing, [va], [to] ? [vz]
        LTOR    to, empty
; expect: [CPSV.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        register_is CPSV, empty, 0
; Z is empty
        descriptor vz, z, 0
        CPSV    [va], [to] ? [vz]
        LTOR    to, zero_bits
        register_is CPSV, zero_bits, 0
; source and result at the same address
        descriptor vz, z, n
        descriptor to, CPSV.place0, n
        descriptor from, CPSV.place0, n
        CPSV    [from], [to] ? [vz]
        LTOR    to, in_place
; expect: [CPSV.place0] = 1.0, 3.0, 4.0, 4.0, 5.0, 6.0
        register_is CPSV, in_place, 3
; C needs room only for the kept elements: here it is the last word of its page
        .data
        .org    0xBFFFC0
CPSV.edge: .word   0
        .code
        EX      to, CPSV.edge
        descriptor vz, CPSV.second, n
        CPSV    [va], [to] ? [vz]
; expect: [CPSV.edge] = 2.0
        flags_are CPSV, X'0000 0000 0000 0000'
; ACPSV: bit Z(i) := 1 if A(i) >= B(i), else 0; C := elements of A where Z has
; ones
        .data
ACPSV.a: .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
ACPSV.b: .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
ACPSV.scalars:
        .word   4.5, 1.0
ACPSV.odd_a: .word   0.0, X'7000 0000 0000 0000', 6, 1.0
ACPSV.odd_b: .word   X'0010 0000 0000 0000', 1.0, 6.0, X'7000 0000 0000 0000'
ACPSV.crowd: .word   1.0, X'4000 0000 0000 0005', 0.5, 3.0
ACPSV.crowded: .space 3
        .code
        .macro  sieve name, a, b
        into_bits ACPSV.\name\()_bits, 0
        RTOR    to, order
        into    ACPSV.\name, 0
        ACPSV   \a, \b, [to], [order]
        LTOR    to, kept
        .data
ACPSV.\name\()_kept: .word 9.0
        .code
        EX      place, ACPSV.\name\()_kept
        STO     [place], kept
        .endm
        operands_of_two ACPSV.
        sieve   plain, [va], [vb]       ; the length is that of A
; expect: [ACPSV.plain] = 3.0, 4.5, 100.0, 9.0, 9.0, 9.0
; expect: [ACPSV.plain_kept] = 3
; expect-bits: [ACPSV.plain_bits] = 00110111
        sieve   broadcast_b, [va], x
; expect: [ACPSV.broadcast_b] = 4.5, 100.0, 9.0, 9.0, 9.0, 9.0
; expect: [ACPSV.broadcast_b_kept] = 2
; expect-bits: [ACPSV.broadcast_b_bits] = 00010111
        sieve   offsets, [va, once], [vb, twice]
; expect: [ACPSV.offsets] = -2.0, 4.5, 100.0, 9.0, 9.0, 9.0
; expect-bits: [ACPSV.offsets_bits] = 10101111
        sieve   short, [short_a], [short_b]     ; B is padded with zeros
; expect: [ACPSV.short] = 3.0, 4.5, 9.0, 9.0, 9.0, 9.0
; expect-bits: [ACPSV.short_bits] = 00111111
        sieve   magnitudes, |[va]|, |[vb]|
; expect-bits: [ACPSV.magnitudes_bits] = 01110111
        ELEN    va, 0
        sieve   nothing, [va], [vb]
; expect: [ACPSV.nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [ACPSV.nothing_kept] = 0
; expect-bits: [ACPSV.nothing_bits] = 11111111
; values are compared, not representations; indefinite is not >= any operand
        descriptor va, ACPSV.odd_a, 4
        descriptor vb, ACPSV.odd_b, 4
        sieve   odd, [va], [vb]
; expect: [ACPSV.odd] = 0.0, 6, 9.0
; expect-bits: [ACPSV.odd_bits] = 10101111
; Z overlaps C: a later element overwrites the first bits.
        descriptor va, ACPSV.crowd, 4
        EX      r140, ACPSV.crowded
        EX      r141, ACPSV.crowded + 64
        load_constant r142, 1.0
        ACPSV   [va], r142, [r140], [r141]
; expect: [ACPSV.crowded] = 1.0, X'5000 0000 0000 0005', 3.0
        flags_are ACPSV, X'0000 0000 0000 0000'
        EXIT
; expect-warning: zero-length
