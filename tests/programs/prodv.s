; PRODV: C := significant product of A, in element order

        .include "reduce.inc"

        .data
a:      .word   1.5, -2.0, 3.0, 4.0, -0.5, 8.0
scalars:
        .word   0.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    PRODV
; expect: [plain] = 144.0
; expect: [where_ones] = 18.0
; expect: [where_zeros] = 8.0
; expect: [offset_source] = -48.0

        signs   PRODV
; expect: [negated] = 144.0
; expect: [magnitudes] = 144.0
; expect: [negative] = 144.0

        empty   PRODV
; expect: [nothing] = 1.0

        .data
odd:    .word   2.0, X'6FFF 7FFF FFFF FFFF', 0.0
        .code
        descriptor va, odd, 3
        PRODV   [va], value
        keep    special
; expect: [special] = X'7000 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0022 0000'
; expect-warning: zero-length
