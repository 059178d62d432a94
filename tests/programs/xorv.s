; XORV: C := A XOR B

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

        uses    XORV
; expect: [plain] = X'FFFF FFFF FFFF FFFF', X'F0F0 F0F0 F0F0 F0F0', 1, 1
; expect: [plain + 4*64] = X'6666 6666 6666 6666', X'FFFF FFFF 0000 0000'
; expect: [broadcast_a] = X'FE23 BA67 76AB 32EF', X'0FF0 0FF0 0FF0 0FF0'
; expect: [broadcast_a + 2*64] = X'00FF 00FF 00FF 00FE', X'80FF 00FF 00FF 00FF'
; expect: [broadcast_a + 4*64] = X'33CC 33CC 33CC 33CC', X'00FF FF00 FF00 00FF'
; expect: [broadcast_b] = X'F1D3 B597 795B 3D1F', X'0F0F 0F0F 0F0F 0F0F'
; expect: [broadcast_b + 2*64] = X'F0F0 F0F0 F0F0 F0F0', X'70F0 F0F0 F0F0 F0F1'
; expect: [broadcast_b + 4*64] = X'A5A5 A5A5 A5A5 A5A5', X'0F0F F0F0 0F0F F0F0'
; expect: [broadcast_both] = X'F00F F00F F00F F00F', X'F00F F00F F00F F00F'
; expect: [broadcast_both + 2*64] = X'F00F F00F F00F F00F'
; expect: [broadcast_both + 3*64] = X'F00F F00F F00F F00F'
; expect: [broadcast_both + 4*64] = X'F00F F00F F00F F00F'
; expect: [broadcast_both + 5*64] = X'F00F F00F F00F F00F'
; expect: [where_ones] = X'FFFF FFFF FFFF FFFF', 9.0, 1, 1, 9.0, 9.0
; expect: [where_zeros] = 9.0, X'F0F0 F0F0 F0F0 F0F0', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'6666 6666 6666 6666', X'FFFF FFFF 0000 0000'
; expect: [offset_sources] = X'FFFF FFFF FFFF FFFE', 0.0
; expect: [offset_sources + 2*64] = X'B333 3333 3333 3332'
; expect: [offset_sources + 3*64] = X'5555 AAAA AAAA 5555'
; expect: [offset_sources + 4*64] = X'FFFF 0000 FFFF 0000', 0
; expect: [offset_result] = 9.0, 9.0, X'F0F0 F0F0 F0F0 F0F0', 1, 9.0, 9.0
; expect: [short_sources] = X'FFFF FFFF FFFF FFFF', X'F0F0 F0F0 F0F0 F0F0', 0
; expect: [short_sources + 3*64] = X'8000 0000 0000 0001', 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap XORV
; expect: [chain] = 1.0, X'010E FA98 7654 3210', X'0E01 F597 795B 3D1F'
; expect: [chain + 3*64] = X'0E01 F597 795B 3D1E', X'8E01 F597 795B 3D1E'
; expect: [chain + 5*64] = X'BD32 C6A4 4A68 0E2D', X'BD32 395B B597 0E2D'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
