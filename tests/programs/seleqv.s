; SELEQV: C := index of the first A = B, or the length

        .include "reduce.inc"

        .data
a:      .word   -1.0, -2.0, 4.5, -3.0, -0.5, 100.0
b:      .word   10.0, 0.5, 4.5, -5.0, -0.5, -0.25
scalars:
        .word   -5.0, -3.0
        .bitvector z, n, "101100"
        .code

        uses_of_two SELEQV
; expect: [plain] = 2
; expect: [broadcast_a] = 3
; expect: [broadcast_b] = 3
; expect: [where_ones] = 2
; expect: [where_zeros] = 4
; counted from the first element after the offset
; expect: [offset_sources] = 0
; expect: [short_source] = 6
; expect: [negated] = 6
; expect: [magnitudes] = 2
; expect: [nothing] = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
