; DIVUV: C := upper(A / B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    DIVUV
; expect: [plain] = X'FFCE 6666 6666 6666', -4.0, -1.0, 1.0, -0.25, -400.0
; expect: [broadcast_a] = X'FFD1 6666 6666 6666', 16.0, X'FFD3 AAAA AAAA AAAB'
; expect: [broadcast_a + 3*64] = X'FFD2 71C7 1C71 C71C', 4.0
; expect: [broadcast_a + 5*64] = X'FFD7 C000 0000 0000'
; expect: [broadcast_b] = X'FFD3 C000 0000 0000', 4.0, -6.0, -9.0, 1.0, -200.0
; expect: [broadcast_both] = X'FFD6 C000 0000 0000', X'FFD6 C000 0000 0000'
; expect: [broadcast_both + 2*64] = X'FFD6 C000 0000 0000'
; expect: [broadcast_both + 3*64] = X'FFD6 C000 0000 0000'
; expect: [broadcast_both + 4*64] = X'FFD6 C000 0000 0000'
; expect: [broadcast_both + 5*64] = X'FFD6 C000 0000 0000'
; expect: [where_ones] = X'FFCE 6666 6666 6666', 9.0, -1.0, 1.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, -4.0, 9.0, 9.0, -0.25, -400.0
; expect: [offset_sources] = X'FFD1 5555 5555 5555', X'FFD1 5555 5555 5555'
; expect: [offset_sources + 2*64] = 2.25, 2.0, 100.0, 1.0
; expect: [offset_result] = 9.0, 9.0, -4.0, -1.0, 9.0, 9.0
; expect: [short_sources] = X'FFCE 6666 6666 6666', -4.0, 3.0, 4.5, 1.0, 1.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap DIVUV
; expect: [chain] = 1.0, X'FFCE 6666 6666 6666', X'FFCF 6666 6666 6666'
; expect: [chain + 3*64] = X'FFCE BBBB BBBB BBBC', X'FFCB 86A3 14DB F86B'
; expect: [chain + 5*64] = X'FFCA 86A3 14DB F86B', X'FFCC 795C EB24 0795'

        signs   DIVUV
; expect: [negated] = X'FFCE 9999 9999 999A', 4.0, 1.0, -1.0, 0.25, 400.0
; expect: [magnitudes] = X'FFCE 6666 6666 6666', 4.0, 1.0, 1.0, 0.25, 400.0
; expect: [negative] = X'FFCE 9999 9999 999A', -4.0, 1.0, -1.0, -0.25, 400.0
; expect: [negated_scalar] = X'FFD1 9999 9999 999A', -16.0
; expect: [negated_scalar + 2*64] = X'FFD3 5555 5555 5555'
; expect: [negated_scalar + 3*64] = X'FFD2 8E38 E38E 38E4', -4.0, 32.0

        .data
odd_a:  .word   42, 0.0, 1.0, 1.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'9000 4000 0000 0000'
odd_b:  .word   6, 7, X'7000 0000 0000 0000', 0.0, 0.125, 4.0
        .code
        specials DIVUV, 6
; expect: [odd] = 7.0, 0.0, X'7000 0000 0000 0000', X'7000 0000 0000 0000'
; expect: [odd + 4*64] = X'7000 0000 0000 0000', 0.0

        EXIT
; expect-flags: X'0000 0000 0072 0000'
