; EQVV: C := NOT (A XOR B)

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

        uses    EQVV
; expect: [plain] = 0, X'0F0F 0F0F 0F0F 0F0F', X'FFFF FFFF FFFF FFFE'
; expect: [plain + 3*64] = X'FFFF FFFF FFFF FFFE', X'9999 9999 9999 9999'
; expect: [plain + 5*64] = 4294967295
; expect: [broadcast_a] = X'01DC 4598 8954 CD10', X'F00F F00F F00F F00F'
; expect: [broadcast_a + 2*64] = X'FF00 FF00 FF00 FF01', X'7F00 FF00 FF00 FF00'
; expect: [broadcast_a + 4*64] = X'CC33 CC33 CC33 CC33', X'FF00 00FF 00FF FF00'
; expect: [broadcast_b] = X'0E2C 4A68 86A4 C2E0', X'F0F0 F0F0 F0F0 F0F0'
; expect: [broadcast_b + 2*64] = X'0F0F 0F0F 0F0F 0F0F', X'8F0F 0F0F 0F0F 0F0E'
; expect: [broadcast_b + 4*64] = X'5A5A 5A5A 5A5A 5A5A', X'F0F0 0F0F F0F0 0F0F'
; expect: [broadcast_both] = X'0FF0 0FF0 0FF0 0FF0', X'0FF0 0FF0 0FF0 0FF0'
; expect: [broadcast_both + 2*64] = X'0FF0 0FF0 0FF0 0FF0'
; expect: [broadcast_both + 3*64] = X'0FF0 0FF0 0FF0 0FF0'
; expect: [broadcast_both + 4*64] = X'0FF0 0FF0 0FF0 0FF0'
; expect: [broadcast_both + 5*64] = X'0FF0 0FF0 0FF0 0FF0'
; expect: [where_ones] = 0, 9.0, X'FFFF FFFF FFFF FFFE', X'FFFF FFFF FFFF FFFE'
; expect: [where_ones + 4*64] = 9.0, 9.0
; expect: [where_zeros] = 9.0, X'0F0F 0F0F 0F0F 0F0F', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'9999 9999 9999 9999', 4294967295
; expect: [offset_sources] = 1, X'7FFF FFFF FFFF FFFF', X'4CCC CCCC CCCC CCCD'
; expect: [offset_sources + 3*64] = X'AAAA 5555 5555 AAAA', -4294901761
; expect: [offset_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [offset_result] = 9.0, 9.0, X'0F0F 0F0F 0F0F 0F0F'
; expect: [offset_result + 3*64] = X'FFFF FFFF FFFF FFFE', 9.0, 9.0
; expect: [short_sources] = 0, X'0F0F 0F0F 0F0F 0F0F', X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 3*64] = X'7FFF FFFF FFFF FFFE'
; expect: [short_sources + 4*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap EQVV
; expect: [chain] = 1.0, X'FEF1 0567 89AB CDEF', X'0E01 F597 795B 3D1F'
; expect: [chain + 3*64] = X'F1FE 0A68 86A4 C2E1', X'8E01 F597 795B 3D1E'
; expect: [chain + 5*64] = X'42CD 395B B597 F1D2', X'BD32 395B B597 0E2D'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
