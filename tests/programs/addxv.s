; ADDXV: C := low 48 bits of A + B; high 16 bits from A

        .include "binary.inc"

        .data
a:      .word   5, -7, X'0064 0000 0000 1000', X'0001 FFFF FFFF FFFF', 100, 0
b:      .word   7, 3, X'FFFF 0000 0000 0040', 1, -100, 8
scalars:
        .word   10, -1
        .bitvector z, n, "101100"
        .code

        uses    ADDXV
; expect: [plain] = 12, -4, X'0064 0000 0000 1040', X'0001 0000 0000 0000', 0, 8
; expect: [broadcast_a] = 17, 13, 74, 11, -90, 18
; expect: [broadcast_b] = 4, -8, X'0064 0000 0000 0FFF', X'0001 FFFF FFFF FFFE'
; expect: [broadcast_b + 4*64] = 99, -1
; expect: [broadcast_both] = 9, 9, 9, 9, 9, 9
; expect: [where_ones] = 12, 9.0, X'0064 0000 0000 1040', X'0001 0000 0000 0000'
; expect: [where_ones + 4*64] = 9.0, 9.0
; expect: [where_zeros] = 9.0, -4, 9.0, 9.0, 0, 8
; zero words follow
; expect: [offset_sources] = 57, X'0064 0000 0000 1001', X'0001 FFFF FFFF FF9B'
; expect: [offset_sources + 3*64] = 108, 0, 0
; expect: [offset_result] = 9.0, 9.0, -4, X'0064 0000 0000 1040', 9.0, 9.0
; expect: [short_sources] = 12, -4, X'0064 0000 0000 1000'
; expect: [short_sources + 3*64] = X'0001 FFFF FFFF FFFF', 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ADDXV
; expect: [chain] = 1.0, X'FFD2 4000 0000 0007', X'FFD2 4000 0000 000A'
; expect: [chain + 3*64] = X'FFD2 4000 0000 004A', X'FFD2 4000 0000 004B'
; expect: [chain + 5*64] = X'FFD2 3FFF FFFF FFE7', X'FFD2 3FFF FFFF FFEF'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
