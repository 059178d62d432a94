; ACPSV: C := those A >= B; length of C := their number; bit Z := A >= B

        .include "vector.inc"

        .regs   r40, kept, one_kept, none_kept, empty
        .regs   r48, order

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   4.5, 1.0
        .bitvector z, n, "111111"
        .code

        .macro  sieve name, a, b, length=n
        into_bits bits_\name, 0
        RTOR    to, order
        into    \name, 0
        ACPSV   \a, \b, [to], [order]
        LTOR    to, kept
        .data
kept_\name:
        .word   9.0
        .code
        EX      place, kept_\name
        STO     [place], kept
        .endm

        operands_of_two
        sieve   plain, [va], [vb]       ; the length is that of A
; expect: [plain] = 3.0, 4.5, 100.0, 9.0, 9.0, 9.0
; expect: [kept_plain] = 3
; expect-bits: [bits_plain] = 00110111

        sieve   broadcast_b, [va], x
; expect: [broadcast_b] = 4.5, 100.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept_broadcast_b] = 2
; expect-bits: [bits_broadcast_b] = 00010111

        sieve   offsets, [va, once], [vb, twice]
; expect: [offsets] = -2.0, 4.5, 100.0, 9.0, 9.0, 9.0
; expect-bits: [bits_offsets] = 10101111

        sieve   short, [short_a], [short_b]     ; B continues with zeros
; expect: [short] = 3.0, 4.5, 9.0, 9.0, 9.0, 9.0
; expect-bits: [bits_short] = 00111111

        sieve   magnitudes, |[va]|, |[vb]|
; expect-bits: [bits_magnitudes] = 01110111

        ELEN    va, 0
        sieve   nothing, [va], [vb]
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept_nothing] = 0
; expect-bits: [bits_nothing] = 11111111

; comparison is that of values; indefinite is not >= anything
        .data
odd_a:  .word   0.0, X'7000 0000 0000 0000', 6, 1.0
odd_b:  .word   X'0010 0000 0000 0000', 1.0, 6.0, X'7000 0000 0000 0000'
        .code
        descriptor va, odd_a, 4
        descriptor vb, odd_b, 4
        sieve   odd, [va], [vb]
; expect: [odd] = 0.0, 6, 9.0
; expect-bits: [bits_odd] = 10101111

; Z lies in C: a later element goes over the first answer.
        .data
crowd:  .word   1.0, X'4000 0000 0000 0005', 0.5, 3.0
crowded: .space 3
        .code
        descriptor va, crowd, 4
        EX      r100, crowded
        EX      r101, crowded + 64
        load_constant r102, 1.0
        ACPSV   [va], r102, [r100], [r101]
; expect: [crowded] = 1.0, X'5000 0000 0000 0005', 3.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
