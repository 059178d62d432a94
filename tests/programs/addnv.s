; ADDNV: C := normalised(A + B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    ADDNV
; expect: [plain] = 11.0, -1.5, 0.0, 9.0, 1.5, 99.75
; expect: [broadcast_a] = 18.0, 8.5, 5.0, 12.5, 10.0, 7.75
; expect: [broadcast_b] = 0.5, -2.5, 2.5, 4.0, -1.0, 99.5
; expect: [broadcast_both] = 7.5, 7.5, 7.5, 7.5, 7.5, 7.5
; expect: [where_ones] = 11.0, 9.0, 0.0, 9.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, -1.5, 9.0, 9.0, 1.5, 99.75
; expect: [offset_sources] = -5.0, 7.5, 6.5, -0.75, 100.0, 0.0
; expect: [offset_result] = 9.0, 9.0, -1.5, 0.0, 9.0, 9.0
; expect: [short_sources] = 11.0, -1.5, 3.0, 4.5, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ADDNV
; expect: [chain] = 1.0, 11.0, 11.5, 8.5, 13.0, 15.0, 14.75

        signs   ADDNV
; expect: [negated] = 9.0, 2.5, -6.0, 0.0, 2.5, -100.25
; expect: [magnitudes] = 11.0, 2.5, 6.0, 9.0, 2.5, 100.25
; expect: [negative] = 9.0, -1.5, -6.0, 0.0, 1.5, -100.25
; expect: [negated_scalar] = 2.0, -7.5, -11.0, -3.5, -6.0, -8.25

        .data
odd_a:  .word   5, 0.0, 1.0, 3.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'0010 0000 0000 0000'
odd_b:  .word   3, 7, X'7000 0000 0000 0000', -3.0, X'6FFF 7FFF FFFF FFFF', 1.0
        .code
        specials ADDNV, 6
; expect: [odd] = 8.0, 7.0, X'7000 0000 0000 0000', 0.0, X'7000 0000 0000 0000'
; expect: [odd + 5*64] = 1.0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
