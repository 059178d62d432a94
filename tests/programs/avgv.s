; AVGV: C := normalised(A + B) / 2

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    AVGV
; expect: [plain] = 5.5, -0.75, 0.0, 4.5, 0.75, 49.875
; expect: [broadcast_a] = 9.0, 4.25, 2.5, 6.25, 5.0, 3.875
; expect: [broadcast_b] = 0.25, -1.25, 1.25, 2.0, -0.5, 49.75
; expect: [broadcast_both] = 3.75, 3.75, 3.75, 3.75, 3.75, 3.75
; expect: [where_ones] = 5.5, 9.0, 0.0, 4.5, 9.0, 9.0
; expect: [where_zeros] = 9.0, -0.75, 9.0, 9.0, 0.75, 49.875
; expect: [offset_sources] = -2.5, 3.75, 3.25, -0.375, 50.0, 0.0
; expect: [offset_result] = 9.0, 9.0, -0.75, 0.0, 9.0, 9.0
; expect: [short_sources] = 5.5, -0.75, 1.5, 2.25, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap AVGV
; expect: [chain] = 1.0, 5.5, 3.0, 0.0, 2.25, 2.125, 0.9375

        signs   AVGV
; expect: [negated] = 4.5, 1.25, -3.0, 0.0, 1.25, -50.125
; expect: [magnitudes] = 5.5, 1.25, 3.0, 4.5, 1.25, 50.125
; expect: [negative] = 4.5, -0.75, -3.0, 0.0, 0.75, -50.125
; expect: [negated_scalar] = 1.0, -3.75, -5.5, -1.75, -3.0, -4.125

        .data
odd_a:  .word   5, 0.0, 1.0, 3.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'0010 0000 0000 0000'
odd_b:  .word   3, 7, X'7000 0000 0000 0000', -3.0, X'6FFF 7FFF FFFF FFFF', 1.0
        .code
        specials AVGV, 6
; expect: [odd] = 4.0, 3.5, X'7000 0000 0000 0000', 0.0, X'7000 0000 0000 0000'
; expect: [odd + 5*64] = 0.5

        EXIT
; expect-flags: X'0000 0000 0032 0000'
