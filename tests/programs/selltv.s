; SELLTV: C := index of the first A < B, or the length

        .include "reduce.inc"

        .data
a:      .word   3.0, -2.0, 4.5, -3.0, -0.5, 100.0
b:      .word   1.0, 0.5, 4.5, -5.0, -0.5, -0.25
scalars:
        .word   -5.0, -3.0
        .bitvector z, n, "101100"
        .code

        uses_of_two SELLTV
; expect: [plain] = 1
; expect: [broadcast_a] = 0
; expect: [broadcast_b] = 6
; expect: [where_ones] = 6
; expect: [where_zeros] = 1
; counted from the first element after the offset
; expect: [offset_sources] = 4
; expect: [short_source] = 1
; expect: [negated] = 0
; expect: [magnitudes] = 3
; expect: [nothing] = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
