; AVGDV: C := normalised(A - B) / 2

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    AVGDV
; expect: [plain] = -4.5, -1.25, 3.0, 0.0, -1.25, 50.125
; expect: [broadcast_a] = -1.0, 3.75, 5.5, 1.75, 3.0, 4.125
; expect: [broadcast_b] = 0.75, -0.75, 1.75, 2.5, 0.0, 50.25
; expect: [broadcast_both] = 4.25, 4.25, 4.25, 4.25, 4.25, 4.25
; expect: [where_ones] = -4.5, 9.0, 3.0, 0.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, -1.25, 9.0, 9.0, -1.25, 50.125
; expect: [offset_sources] = 0.5, -0.75, 1.25, -0.125, 50.0, 0.0
; expect: [offset_result] = 9.0, 9.0, -1.25, 3.0, 9.0, 9.0
; expect: [short_sources] = -4.5, -1.25, 1.5, 2.25, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap AVGDV
; expect: [chain] = 1.0, -4.5, -2.5, 0.25, -2.125, -2.0625, -0.90625

        signs   AVGDV
; expect: [negated] = -5.5, 0.75, 0.0, -4.5, -0.75, -49.875
; expect: [magnitudes] = -4.5, 0.75, 0.0, 0.0, -0.75, 49.875
; expect: [negative] = -5.5, -1.25, 0.0, -4.5, -1.25, -49.875
; expect: [negated_scalar] = -9.0, -4.25, -2.5, -6.25, -5.0, -3.875

        .data
odd_a:  .word   5, 0.0, 1.0, 3.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'0010 0000 0000 0000'
odd_b:  .word   3, 7, X'7000 0000 0000 0000', -3.0, X'6FFF 7FFF FFFF FFFF', 1.0
        .code
        specials AVGDV, 6
; expect: [odd] = 1.0, -3.5, X'7000 0000 0000 0000', 3.0, 0.0, -0.5

        EXIT
; expect-flags: X'0000 0000 0012 0000'
