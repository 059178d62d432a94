; VREVV: C := A, last element first: C(i) := A(n - 1 - i), n the length of C

        .include "unary.inc"

        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    VREVV
; expect: [plain] = 0.75, 100.0, -0.5, 16.0, -2.25, 2.25
; expect: [broadcast] = 8.0, 8.0, 8.0, 8.0, 8.0, 8.0
; expect: [where_ones] = 0.75, 9.0, -0.5, 16.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, 100.0, 9.0, 9.0, -2.25, 2.25
; expect: [offset_source] = 0.0, 0.0, 0.75, 100.0, -0.5, 16.0
; expect: [offset_result] = 9.0, 9.0, -0.5, 16.0, 9.0, 9.0
; expect: [short_source] = 0.0, 0.0, -0.5, 16.0, -2.25, 2.25
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap VREVV
; expect: [chain] = 2.25, 1.0, 5.0, -8.0, 5.0, 1.0, 2.25

        EXIT
; expect-flags: X'0000 0000 0000 0000'
