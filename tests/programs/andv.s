; ANDV: C := A AND B

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

        uses    ANDV
; expect: [plain] = 0, X'0F0F 0F0F 0F0F 0F0F', 0, 0.0, X'1111 1111 1111 1111'
; expect: [plain + 5*64] = 4294901760
; expect: [broadcast_a] = X'00DC 0098 0054 0010', X'000F 000F 000F 000F', 1, 0
; expect: [broadcast_a + 4*64] = X'0033 0033 0033 0033', 1095233372160
; expect: [broadcast_b] = X'0020 4060 80A0 C0E0', X'F0F0 F0F0 F0F0 F0F0', 0
; expect: [broadcast_b + 3*64] = 0.0, X'5050 5050 5050 5050'
; expect: [broadcast_b + 5*64] = X'F0F0 0000 F0F0 0000'
; expect: [broadcast_both] = X'00F0 00F0 00F0 00F0', X'00F0 00F0 00F0 00F0'
; expect: [broadcast_both + 2*64] = X'00F0 00F0 00F0 00F0'
; expect: [broadcast_both + 3*64] = X'00F0 00F0 00F0 00F0'
; expect: [broadcast_both + 4*64] = X'00F0 00F0 00F0 00F0'
; expect: [broadcast_both + 5*64] = X'00F0 00F0 00F0 00F0'
; expect: [where_ones] = 0, 9.0, 0, 0.0, 9.0, 9.0
; expect: [where_zeros] = 9.0, X'0F0F 0F0F 0F0F 0F0F', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'1111 1111 1111 1111', 4294901760
; expect: [offset_sources] = 1, 0, 1, X'0000 5555 5555 0000', 0, 0
; expect: [offset_result] = 9.0, 9.0, X'0F0F 0F0F 0F0F 0F0F', 0, 9.0, 9.0
; expect: [short_sources] = 0, X'0F0F 0F0F 0F0F 0F0F', 0, 0, 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ANDV
; expect: [chain] = 1.0, X'FED0 0000 0000 0000', X'0E00 0000 0000 0000', 0, 0
; expect: [chain + 5*64] = 0, 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
