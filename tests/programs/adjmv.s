; ADJMV: C(i) := normalised(A(i+1) + A(i)) / 2

        .include "unary.inc"

        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    ADJMV
; expect: [plain] = 0.0, 6.875, 7.75, 49.75, 50.375, 0.375
; expect: [broadcast] = 8.0, 8.0, 8.0, 8.0, 8.0, 8.0
; expect: [where_ones] = 0.0, 9.0, 7.75, 49.75, 9.0, 9.0
; expect: [where_zeros] = 9.0, 6.875, 9.0, 9.0, 50.375, 0.375
; expect: [offset_source] = 7.75, 49.75, 50.375, 0.375, 0.0, 0.0
; expect: [offset_result] = 9.0, 9.0, 6.875, 7.75, 9.0, 9.0
; expect: [short_source] = 0.0, 6.875, 7.75, -0.25, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ADJMV
; expect: [chain] = 2.25, 9.125, 6.3125, -0.84375, 2.078125, 1.5390625
; expect: [chain + 6*64] = 0.76953125

        signs   ADJMV
; expect: [negated] = 0.0, -6.875, -7.75, -49.75, -50.375, -0.375
; expect: [magnitudes] = 2.25, 9.125, 8.25, 50.25, 50.375, 0.375
; expect: [negative] = -2.25, -9.125, -8.25, -50.25, -50.375, -0.375

        .data
odd_a:  .word   5, 3, X'7000 0000 0000 0000', 1.0, 0.0, 2.0
        .code
        specials ADJMV, 6
; expect: [odd] = 4.0, X'7000 0000 0000 0000', X'7000 0000 0000 0000', 0.5, 1.0
; expect: [odd + 5*64] = 1.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: recurrence
