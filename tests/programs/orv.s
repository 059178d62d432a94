; ORV: C := A OR B

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

        uses    ORV
; expect: [plain] = X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF', 1
; expect: [plain + 3*64] = X'8000 0000 0000 0001', X'7777 7777 7777 7777'
; expect: [plain + 5*64] = X'FFFF FFFF FFFF 0000'
; expect: [broadcast_a] = X'FEFF BAFF 76FF 32FF', X'0FFF 0FFF 0FFF 0FFF'
; expect: [broadcast_a + 2*64] = X'00FF 00FF 00FF 00FF', X'80FF 00FF 00FF 00FF'
; expect: [broadcast_a + 4*64] = X'33FF 33FF 33FF 33FF', X'00FF FFFF FFFF 00FF'
; expect: [broadcast_b] = X'F1F3 F5F7 F9FB FDFF', X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_b + 2*64] = X'F0F0 F0F0 F0F0 F0F0', X'F0F0 F0F0 F0F0 F0F1'
; expect: [broadcast_b + 4*64] = X'F5F5 F5F5 F5F5 F5F5', X'FFFF F0F0 FFFF F0F0'
; expect: [broadcast_both] = X'F0FF F0FF F0FF F0FF', X'F0FF F0FF F0FF F0FF'
; expect: [broadcast_both + 2*64] = X'F0FF F0FF F0FF F0FF'
; expect: [broadcast_both + 3*64] = X'F0FF F0FF F0FF F0FF'
; expect: [broadcast_both + 4*64] = X'F0FF F0FF F0FF F0FF'
; expect: [broadcast_both + 5*64] = X'F0FF F0FF F0FF F0FF'
; expect: [where_ones] = X'FFFF FFFF FFFF FFFF', 9.0, 1, X'8000 0000 0000 0001'
; expect: [where_ones + 4*64] = 9.0, 9.0
; expect: [where_zeros] = 9.0, X'FFFF FFFF FFFF FFFF', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'7777 7777 7777 7777', X'FFFF FFFF FFFF 0000'
; expect: [offset_sources] = X'FFFF FFFF FFFF FFFF', 0.0
; expect: [offset_sources + 2*64] = X'B333 3333 3333 3333'
; expect: [offset_sources + 3*64] = X'5555 FFFF FFFF 5555'
; expect: [offset_sources + 4*64] = X'FFFF 0000 FFFF 0000', 0
; expect: [offset_result] = 9.0, 9.0, X'FFFF FFFF FFFF FFFF', 1, 9.0, 9.0
; expect: [short_sources] = X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF', 0
; expect: [short_sources + 3*64] = X'8000 0000 0000 0001', 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ORV
; expect: [chain] = 1.0, X'FFDE FA98 7654 3210', X'FFDF FF9F 7F5F 3F1F'
; expect: [chain + 3*64] = X'FFDF FF9F 7F5F 3F1F', X'FFDF FF9F 7F5F 3F1F'
; expect: [chain + 5*64] = X'FFFF FFBF 7F7F 3F3F', X'FFFF FFFF FFFF 3F3F'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
