; ANDNV: C := A AND NOT B

        .include "binary.inc"

        .data
a:      .word   X'0123 4567 89AB CDEF', X'FFFF FFFF FFFF FFFF'
        .word   X'0000 0000 0000 0000', X'8000 0000 0000 0001'
        .word   X'5555 5555 5555 5555', X'FFFF 0000 FFFF 0000'
b:      .word   X'FEDC BA98 7654 3210', X'0F0F 0F0F 0F0F 0F0F'
        .word   X'0000 0000 0000 0001', X'8000 0000 0000 0000'
        .word   X'3333 3333 3333 3333', X'0000 FFFF FFFF 0000'
scalars:
        .word   X'00FF 00FF 00FF 00FF', X'F0F0 F0F0 F0F0 F0F0'
        .bitvector z, n, "101100"
        .code

        uses    ANDNV
; expect: [plain] = X'0123 4567 89AB CDEF', X'F0F0 F0F0 F0F0 F0F0', 0, 1
; expect: [plain + 4*64] = X'4444 4444 4444 4444', X'FFFF 0000 0000 0000'
; expect: [broadcast_a] = X'0023 0067 00AB 00EF', X'00F0 00F0 00F0 00F0'
; expect: [broadcast_a + 2*64] = X'00FF 00FF 00FF 00FE', X'00FF 00FF 00FF 00FF'
; expect: [broadcast_a + 4*64] = X'00CC 00CC 00CC 00CC', X'00FF 0000 0000 00FF'
; expect: [broadcast_b] = X'0103 0507 090B 0D0F', X'0F0F 0F0F 0F0F 0F0F', 0, 1
; expect: [broadcast_b + 4*64] = X'0505 0505 0505 0505', X'0F0F 0000 0F0F 0000'
; expect: [broadcast_both] = X'000F 000F 000F 000F', X'000F 000F 000F 000F'
; expect: [broadcast_both + 2*64] = X'000F 000F 000F 000F'
; expect: [broadcast_both + 3*64] = X'000F 000F 000F 000F'
; expect: [broadcast_both + 4*64] = X'000F 000F 000F 000F'
; expect: [broadcast_both + 5*64] = X'000F 000F 000F 000F'
; expect: [where_ones] = X'0123 4567 89AB CDEF', 9.0, 0, 1, 9.0, 9.0
; expect: [where_zeros] = 9.0, X'F0F0 F0F0 F0F0 F0F0', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'4444 4444 4444 4444', X'FFFF 0000 0000 0000'
; expect: [offset_sources] = X'FFFF FFFF FFFF FFFE', 0, 0.0
; expect: [offset_sources + 3*64] = X'5555 0000 0000 5555'
; expect: [offset_sources + 4*64] = X'FFFF 0000 FFFF 0000', 0
; expect: [offset_result] = 9.0, 9.0, X'F0F0 F0F0 F0F0 F0F0', 0, 9.0, 9.0
; expect: [short_sources] = X'0123 4567 89AB CDEF', X'F0F0 F0F0 F0F0 F0F0', 0
; expect: [short_sources + 3*64] = X'8000 0000 0000 0001', 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ANDNV
; expect: [chain] = 1.0, X'0102 4000 0000 0000', X'0000 4000 0000 0000'
; expect: [chain + 3*64] = X'0000 4000 0000 0000', X'0000 4000 0000 0000'
; expect: [chain + 5*64] = X'0000 4000 0000 0000', 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
