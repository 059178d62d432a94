; ADDUV: C := upper(A + B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    ADDUV
; expect: [plain] = 11.0, -1.5, X'FFD3 0000 0000 0000', 9.0
; expect: [plain + 4*64] = X'FFD3 3000 0000 0000', 99.75
; expect: [broadcast_a] = 18.0, 8.5, X'FFD5 2800 0000 0000', 12.5, 10.0
; expect: [broadcast_a + 5*64] = X'FFD5 3E00 0000 0000'
; expect: [broadcast_b] = X'FFD2 2000 0000 0000', -2.5, 2.5, 4.0, -1.0, 99.5
; expect: [broadcast_both] = X'FFD5 3C00 0000 0000', X'FFD5 3C00 0000 0000'
; expect: [broadcast_both + 2*64] = X'FFD5 3C00 0000 0000'
; expect: [broadcast_both + 3*64] = X'FFD5 3C00 0000 0000'
; expect: [broadcast_both + 4*64] = X'FFD5 3C00 0000 0000'
; expect: [broadcast_both + 5*64] = X'FFD5 3C00 0000 0000'
; expect: [where_ones] = 11.0, 9.0, X'FFD3 0000 0000 0000', 9.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, -1.5, 9.0, 9.0, X'FFD3 3000 0000 0000', 99.75
; expect: [offset_sources] = -5.0, 7.5, 6.5, -0.75, 100.0, 0.0
; expect: [offset_result] = 9.0, 9.0, -1.5, X'FFD3 0000 0000 0000', 9.0, 9.0
; expect: [short_sources] = 11.0, -1.5, 3.0, 4.5, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ADDUV
; expect: [chain] = 1.0, 11.0, 11.5, 8.5, 13.0, 15.0, 14.75

        signs   ADDUV
; expect: [negated] = 9.0, 2.5, -6.0, X'FFD4 0000 0000 0000', 2.5, -100.25
; expect: [magnitudes] = 11.0, 2.5, 6.0, 9.0, 2.5, 100.25
; expect: [negative] = 9.0, -1.5, -6.0, X'FFD4 0000 0000 0000'
; expect: [negative + 4*64] = X'FFD3 3000 0000 0000', -100.25
; expect: [negated_scalar] = X'FFD5 1000 0000 0000', -7.5, -11.0
; expect: [negated_scalar + 3*64] = X'FFD4 C800 0000 0000', -6.0, -8.25

        .data
odd_a:  .word   5, 0.0, 1.0, 3.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'0010 0000 0000 0000'
odd_b:  .word   3, 7, X'7000 0000 0000 0000', -3.0, X'6FFF 7FFF FFFF FFFF', 1.0
        .code
        specials ADDUV, 6
; expect: [odd] = 8, 7, X'7000 0000 0000 0000', X'FFD3 0000 0000 0000'
; expect: [odd + 4*64] = X'7000 0000 0000 0000', X'0010 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0032 0000'
