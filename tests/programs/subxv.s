; SUBXV: C := low 48 bits of A - B; high 16 bits from A

        .include "binary.inc"

        .data
a:      .word   5, -7, X'0064 0000 0000 1000', X'0001 FFFF FFFF FFFF', 100, 0
b:      .word   7, 3, X'FFFF 0000 0000 0040', 1, -100, 8
scalars:
        .word   10, -1
        .bitvector z, n, "101100"
        .code

        uses    SUBXV
; expect: [plain] = -2, -10, X'0064 0000 0000 0FC0', X'0001 FFFF FFFF FFFE'
; expect: [plain + 4*64] = 200, -8
; expect: [broadcast_a] = 3, 7, -54, 9, 110, 2
; expect: [broadcast_b] = 6, -6, X'0064 0000 0000 1001', X'0001 0000 0000 0000'
; expect: [broadcast_b + 4*64] = 101, 1
; expect: [broadcast_both] = 11, 11, 11, 11, 11, 11
; expect: [where_ones] = -2, 9.0, X'0064 0000 0000 0FC0', X'0001 FFFF FFFF FFFE'
; expect: [where_ones + 4*64] = 9.0, 9.0
; expect: [where_zeros] = 9.0, -10, 9.0, 9.0, 200, -8
; zero words follow
; expect: [offset_sources] = -71, X'0064 0000 0000 0FFF', X'0001 0000 0000 0063'
; expect: [offset_sources + 3*64] = 92, 0, 0
; expect: [offset_result] = 9.0, 9.0, -10, X'0064 0000 0000 0FC0', 9.0, 9.0
; expect: [short_sources] = -2, -10, X'0064 0000 0000 1000'
; expect: [short_sources + 3*64] = X'0001 FFFF FFFF FFFF', 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap SUBXV
; expect: [chain] = 1.0, X'FFD2 3FFF FFFF FFF9', X'FFD2 3FFF FFFF FFF6'
; expect: [chain + 3*64] = X'FFD2 3FFF FFFF FFB6', X'FFD2 3FFF FFFF FFB5'
; expect: [chain + 5*64] = X'FFD2 4000 0000 0019', X'FFD2 4000 0000 0011'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
