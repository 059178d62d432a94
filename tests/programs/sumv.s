; SUMV: C := normalised sum of A, in element order

        .include "reduce.inc"

        .data
a:      .word   1.5, -2.0, 3.0, 4.5, -0.5, 100.0
scalars:
        .word   0.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    SUMV
; expect: [plain] = 106.5
; expect: [where_ones] = 9.0
; expect: [where_zeros] = 97.5
; expect: [offset_source] = 107.0

        signs   SUMV
; expect: [negated] = -106.5
; expect: [magnitudes] = 111.5
; expect: [negative] = -111.5

        empty   SUMV
; expect: [nothing] = 0.0

; In element order: the first 1.0 is lost beside 2^94, the last is not.
        .data
large:  .word   X'0030 4000 0000 0000', 1.0, X'002F 8000 0000 0000', 1.0
        .code
        descriptor va, large, 4
        SUMV    [va], value
        keep    order
; expect: [order] = 1.0

        .data
odd:    .word   1.0, X'7000 0000 0000 0000', 2.0
        .code
        descriptor va, odd, 3
        SUMV    [va], value
        keep    special
; expect: [special] = X'7000 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: zero-length
