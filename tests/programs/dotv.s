; DOTV: C := normalised sum of significant(A x B), in element order

        .include "reduce.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   2.0, -4.0
        .bitvector z, n, "101100"
        .code

        uses_of_two DOTV
; expect: [plain] = -5.75
; expect: [broadcast_a] = 27.5
; expect: [broadcast_b] = -424.0
; expect: [where_ones] = 21.25
; expect: [where_zeros] = -27.0
; expect: [offset_sources] = -14.75
; a short source continues with ones
; expect: [short_source] = 116.0
; expect: [negated] = 5.75
; expect: [magnitudes] = 66.25
; expect: [nothing] = 0.0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
