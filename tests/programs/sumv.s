; SUMV: C, C+1 := upper and lower part of the sum of A, in element order

        .include "reduce.inc"

        .data
a:      .word   1.5, -2.0, 3.0, 4.5, -0.5, 100.0
scalars:
        .word   0.0, 0.0
        .bitvector z, n, "101100"
        .code

; the upper part, and in the word after the lower one
        uses    SUMV
; expect: [plain] = 106.5, 0.0 ~ 0
; expect: [where_ones] = 9.0, 0.0 ~ 0
; expect: [where_zeros] = 97.5, 0.0 ~ 0
; expect: [offset_source] = 107.0, 0.0 ~ 0

        signs   SUMV
; expect: [negated] = -106.5, 0.0 ~ 0
; expect: [magnitudes] = 111.5, 0.0 ~ 0
; expect: [negative] = -111.5, 0.0 ~ 0

        empty   SUMV
; expect: [nothing] = X'8000 0000 0000 0000', X'8000 0000 0000 0000'

; To the bit.  1.0 is 2^46 x 2^-46, 2^-60 is 2^46 x 2^-106: shifted right by 60
; in the register of 95 bits it is 2^33, all of it in the lower part, which has
; the exponent -46 - 47 = -93.
        .data
fine:   .word   1.0, X'FF96 4000 0000 0000', X'FF96 4000 0000 0000'
        .code
        descriptor va, fine, 2
        SUMV    [va], value
        keep    one_small
; expect: [one_small] = 1.0, X'FFA3 0002 0000 0000'
        ELEN    va, 3
        SUMV    [va], value
        keep    two_small
; expect: [two_small] = 1.0, X'FFA3 0004 0000 0000'

; What cancels leaves its exponent: 2^60 - 2^60 is 0 x 2^14 above.  Each 1.0 is
; below, with the exponent 14 - 47, and is not lost beside it; join_parts makes
; one number of them, and ADDN with ADDL two, to go on with.
        .data
large:  .word   X'000E 4000 0000 0000', 1.0, X'000D 8000 0000 0000', 1.0
        .code
        descriptor va, large, 4
        SUMV    [va], value
        keep    cancelled
; expect: [cancelled] = X'000E 0000 0000 0000', X'FFDF 0004 0000 0000'
        join_parts value, index, value
        keep    joined
; expect: [joined] = 2.0
        ELEN    va, 2
        SUMV    [va], value
        ADDL    value, index, place
        ADDN    value, index, value
        RTOR    place, index
        keep    both
; expect: [both] = X'000E 4000 0000 0000', X'FFDF 0002 0000 0000'

; Beside 2^94 a 1.0 is beyond the register, and so it is beside what 2^94 leaves
; when it cancels.
        .data
larger: .word   X'0030 4000 0000 0000', 1.0, X'002F 8000 0000 0000', 1.0
        .code
        descriptor va, larger, 4
        SUMV    [va], value
        keep    lost
; expect: [lost] = X'0030 0000 0000 0000', X'0001 0000 0000 0000'

        .data
odd:    .word   1.0, X'7000 0000 0000 0000', 2.0
        .code
        descriptor va, odd, 3
        SUMV    [va], value
        keep    special
; expect: [special] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'

; With r0 neither part is stored.
        ES      r1, 7
        SUMV    [va], r0
; expect: r1 = 7

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: zero-length
