; MPYUV: C := upper(A x B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    MPYUV
; expect: [plain] = X'FFD6 2800 0000 0000', X'FFD2 C000 0000 0000', -9.0
; expect: [plain + 3*64] = X'FFD7 2880 0000 0000', X'FFD2 C000 0000 0000'
; expect: [plain + 5*64] = -25.0
; expect: [broadcast_a] = X'FFD9 2800 0000 0000', X'FFD5 2000 0000 0000'
; expect: [broadcast_a + 2*64] = X'FFD7 D000 0000 0000', X'FFD8 2400 0000 0000'
; expect: [broadcast_a + 4*64] = X'FFD7 2000 0000 0000', X'FFD3 C000 0000 0000'
; expect: [broadcast_b] = X'FFD1 C000 0000 0000', 1.0, -1.5, -2.25, 0.25, -50.0
; expect: [broadcast_both] = X'FFD4 C000 0000 0000', X'FFD4 C000 0000 0000'
; expect: [broadcast_both + 2*64] = X'FFD4 C000 0000 0000'
; expect: [broadcast_both + 3*64] = X'FFD4 C000 0000 0000'
; expect: [broadcast_both + 4*64] = X'FFD4 C000 0000 0000'
; expect: [broadcast_both + 5*64] = X'FFD4 C000 0000 0000'
; expect: [where_ones] = X'FFD6 2800 0000 0000', 9.0, -9.0
; expect: [where_ones + 3*64] = X'FFD7 2880 0000 0000', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'FFD2 C000 0000 0000', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'FFD2 C000 0000 0000', -25.0
; expect: [offset_sources] = 6.0, X'FFD6 3600 0000 0000'
; expect: [offset_sources + 2*64] = X'FFD6 2400 0000 0000', 0.125
; expect: [offset_sources + 4*64] = X'FFD9 3200 0000 0000'
; expect: [offset_sources + 5*64] = X'FFD3 2000 0000 0000'
; expect: [offset_result] = 9.0, 9.0, X'FFD2 C000 0000 0000', -9.0, 9.0, 9.0
; expect: [short_sources] = X'FFD6 2800 0000 0000', X'FFD2 C000 0000 0000'
; expect: [short_sources + 2*64] = X'FFD4 3000 0000 0000'
; expect: [short_sources + 3*64] = X'FFD5 2400 0000 0000'
; expect: [short_sources + 4*64] = X'FFD3 2000 0000 0000'
; expect: [short_sources + 5*64] = X'FFD3 2000 0000 0000'
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap MPYUV
; expect: [chain] = 1.0, X'FFD6 2800 0000 0000', X'FFD6 1400 0000 0000'
; expect: [chain + 3*64] = X'FFD8 F100 0000 0000', X'FFDB F790 0000 0000'
; expect: [chain + 5*64] = X'FFDD FBC8 0000 0000', X'FFDB 0438 0000 0000'

        signs   MPYUV
; expect: [negated] = -10.0, X'FFD3 2000 0000 0000', 9.0
; expect: [negated + 3*64] = X'FFD7 D780 0000 0000', X'FFD3 2000 0000 0000'
; expect: [negated + 5*64] = 25.0
; expect: [magnitudes] = X'FFD6 2800 0000 0000', X'FFD3 2000 0000 0000', 9.0
; expect: [magnitudes + 3*64] = X'FFD7 2880 0000 0000', X'FFD3 2000 0000 0000'
; expect: [magnitudes + 5*64] = X'FFD7 3200 0000 0000'
; expect: [negative] = -10.0, X'FFD2 C000 0000 0000', 9.0
; expect: [negative + 3*64] = X'FFD7 D780 0000 0000', X'FFD2 C000 0000 0000'
; expect: [negative + 5*64] = 25.0
; expect: [negated_scalar] = -80.0, X'FFD4 C000 0000 0000', 24.0, -36.0
; expect: [negated_scalar + 4*64] = X'FFD6 C000 0000 0000', 2.0

        .data
odd_a:  .word   6, 0.0, 1.0, X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        .word   X'9000 4000 0000 0000'
odd_b:  .word   7, 7, X'7000 0000 0000 0000', X'0000 8000 0000 0000', 8.0, 0.25
        .code
        specials MPYUV, 6
; expect: [odd] = X'002F 0000 0000 0000', 0.0, X'7000 0000 0000 0000'
; expect: [odd + 3*64] = X'0030 4000 0000 0000', X'7000 0000 0000 0000', 0.0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
; expect-warning: integer-operand
