; DOTV: C, C+1 := upper and lower part of the sum of A x B, in element order

        .include "reduce.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   2.0, -4.0
        .bitvector z, n, "101100"
        .code

; the upper part, and in the word after the lower one
        uses_of_two DOTV
; expect: [plain] = -5.75, 0.0 ~ 0
; expect: [broadcast_a] = 27.5, 0.0 ~ 0
; expect: [broadcast_b] = -424.0, 0.0 ~ 0
; expect: [where_ones] = 21.25, 0.0 ~ 0
; expect: [where_zeros] = -27.0, 0.0 ~ 0
; expect: [offset_sources] = -14.75, 0.0 ~ 0
; a short source continues with ones
; expect: [short_source] = 116.0, 0.0 ~ 0
; expect: [negated] = 5.75, 0.0 ~ 0
; expect: [magnitudes] = 66.25, 0.0 ~ 0
; expect: [nothing] = X'8000 0000 0000 0000', X'8000 0000 0000 0000'

; To the bit.  (1 + 2^-46)^2 = 1 + 2^-45 + 2^-92: of the product of coefficients,
; 2^92 + 2^47 + 1, the upper part is 2^45 + 1 with the exponent -45, the lower one
; 1 with the exponent -92.  1.0 x 2^-60 has the upper part 2^45 with the exponent
; -105, which shifted right by 60 is 2^32 below.
        .data
fine_a: .word   X'FFD2 4000 0000 0001', 1.0
fine_b: .word   X'FFD2 4000 0000 0001', X'FF96 4000 0000 0000'
        .code
        descriptor va, fine_a, 1
        descriptor vb, fine_b, 1
        DOTV    [va], [vb], value
        keep    square
; expect: [square] = X'FFD3 2000 0000 0001', X'FFA4 0000 0000 0001'
        ELEN    va, 2
        ELEN    vb, 2
        DOTV    [va], [vb], value
        keep    two_products
; expect: [two_products] = X'FFD3 2000 0000 0001', X'FFA4 0001 0000 0001'

; The upper part is normalised; then one more addition makes a number of both,
; and its lower form what that leaves.
        ADDN    value, r0, value
        ADDL    value, index, place
        ADDN    value, index, value
        RTOR    place, index
        keep    both
; expect: [both] = X'FFD2 4000 0000 0002', X'FFA3 0002 0000 0002'

        .data
odd_a:  .word   2.0, X'8000 0000 0000 0000', 1.0
odd_b:  .word   3.0, 5.0, X'7000 0000 0000 0000'
        .code
        descriptor va, odd_a, 2
        descriptor vb, odd_b, 2
        DOTV    [va], [vb], value       ; machine zero adds nothing
        keep    zero
; expect: [zero] = 6.0, 0.0 ~ 0
        ELEN    va, 3
        ELEN    vb, 3
        DOTV    [va], [vb], value
        keep    special
; expect: [special] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'

; With r0 neither part is stored.
        ES      r1, 7
        DOTV    [va], [vb], r0
; expect: r1 = 7

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: zero-length
