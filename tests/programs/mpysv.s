; MPYSV: C := significant(A x B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    MPYSV
; expect: [plain] = 10.0, -1.0, -9.0, 20.25, -1.0, -25.0
; expect: [broadcast_a] = 80.0, 4.0, -24.0, 36.0, 16.0, -2.0
; expect: [broadcast_b] = -0.5, 1.0, -1.5, -2.25, 0.25, -50.0
; expect: [broadcast_both] = -4.0, -4.0, -4.0, -4.0, -4.0, -4.0
; expect: [where_ones] = 10.0, 9.0, -9.0, 20.25, 9.0, 9.0
; expect: [where_zeros] = 9.0, -1.0, 9.0, 9.0, -1.0, -25.0
; expect: [offset_sources] = 6.0, 13.5, 9.0, 0.125, 100.0, 1.0
; expect: [offset_result] = 9.0, 9.0, -1.0, -9.0, 9.0, 9.0
; expect: [short_sources] = 10.0, -1.0, 3.0, 4.5, 1.0, 1.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap MPYSV
; expect: [chain] = 1.0, 10.0, 5.0, -15.0, -67.5, -135.0, 33.75

        signs   MPYSV
; expect: [negated] = -10.0, 1.0, 9.0, -20.25, 1.0, 25.0
; expect: [magnitudes] = 10.0, 1.0, 9.0, 20.25, 1.0, 25.0
; expect: [negative] = -10.0, -1.0, 9.0, -20.25, -1.0, 25.0
; expect: [negated_scalar] = -80.0, -4.0, 24.0, -36.0, -16.0, 2.0

        .data
odd_a:  .word   6, 0.0, 1.0, X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        .word   X'9000 4000 0000 0000'
odd_b:  .word   7, 7, X'7000 0000 0000 0000', X'0000 8000 0000 0000', 8.0, 0.25
        .code
        specials MPYSV, 6
; expect: [odd] = X'0003 0000 0000 0005', 0.0, X'7000 0000 0000 0000'
; expect: [odd + 3*64] = X'0030 4000 0000 0000', X'7000 0000 0000 0000', 0.0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
; expect-warning: integer-operand
