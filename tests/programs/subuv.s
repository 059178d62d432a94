; SUBUV: C := upper(A - B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    SUBUV
; expect: [plain] = -9.0, -2.5, 6.0, X'FFD4 0000 0000 0000', -2.5, 100.25
; expect: [broadcast_a] = X'FFD5 F000 0000 0000', X'FFD5 3C00 0000 0000', 11.0
; expect: [broadcast_a + 3*64] = X'FFD5 1C00 0000 0000', X'FFD5 3000 0000 0000'
; expect: [broadcast_a + 5*64] = 8.25
; expect: [broadcast_b] = 1.5, -1.5, 3.5, 5.0, X'FFD0 0000 0000 0000', 100.5
; expect: [broadcast_both] = 8.5, 8.5, 8.5, 8.5, 8.5, 8.5
; expect: [where_ones] = -9.0, 9.0, 6.0, X'FFD4 0000 0000 0000', 9.0, 9.0
; expect: [where_zeros] = 9.0, -2.5, 9.0, 9.0, -2.5, 100.25
; expect: [offset_sources] = X'FFD3 2000 0000 0000', X'FFD4 E800 0000 0000'
; expect: [offset_sources + 2*64] = X'FFD4 2800 0000 0000'
; expect: [offset_sources + 3*64] = X'FFD0 C000 0000 0000', 100.0, 0.0
; expect: [offset_result] = 9.0, 9.0, -2.5, 6.0, 9.0, 9.0
; expect: [short_sources] = -9.0, -2.5, 3.0, 4.5, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap SUBUV
; expect: [chain] = 1.0, -9.0, -9.5, X'FFD5 CC00 0000 0000', -11.0, -13.0
; expect: [chain + 6*64] = -12.75

        signs   SUBUV
; expect: [negated] = -11.0, X'FFD3 3000 0000 0000', X'FFD3 0000 0000 0000'
; expect: [negated + 3*64] = -9.0, X'FFD3 D000 0000 0000', -99.75
; expect: [magnitudes] = -9.0, X'FFD3 3000 0000 0000', X'FFD3 0000 0000 0000'
; expect: [magnitudes + 3*64] = X'FFD4 0000 0000 0000', X'FFD3 D000 0000 0000'
; expect: [magnitudes + 5*64] = 99.75
; expect: [negative] = -11.0, -2.5, X'FFD3 0000 0000 0000', -9.0, -2.5, -99.75
; expect: [negated_scalar] = -18.0, -8.5, -5.0, -12.5, -10.0, -7.75

        .data
odd_a:  .word   5, 0.0, 1.0, 3.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'0010 0000 0000 0000'
odd_b:  .word   3, 7, X'7000 0000 0000 0000', -3.0, X'6FFF 7FFF FFFF FFFF', 1.0
        .code
        specials SUBUV, 6
; expect: [odd] = 2, -7, X'7000 0000 0000 0000', 6.0, X'6FFF 0000 0000 0000'
; expect: [odd + 5*64] = X'0010 FFFF FFFF FFFF'

        EXIT
; expect-flags: X'0000 0000 0012 0000'
