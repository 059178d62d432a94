; ORNV: C := A OR NOT B

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

        uses    ORNV
; expect: [plain] = X'0123 4567 89AB CDEF', X'FFFF FFFF FFFF FFFF'
; expect: [plain + 2*64] = X'FFFF FFFF FFFF FFFE', X'FFFF FFFF FFFF FFFF'
; expect: [plain + 4*64] = X'DDDD DDDD DDDD DDDD', X'FFFF 0000 FFFF FFFF'
; expect: [broadcast_a] = X'01FF 45FF 89FF CDFF', X'F0FF F0FF F0FF F0FF'
; expect: [broadcast_a + 2*64] = X'FFFF FFFF FFFF FFFF', X'7FFF FFFF FFFF FFFF'
; expect: [broadcast_a + 4*64] = X'CCFF CCFF CCFF CCFF', X'FFFF 00FF 00FF FFFF'
; expect: [broadcast_b] = X'0F2F 4F6F 8FAF CFEF', X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_b + 2*64] = X'0F0F 0F0F 0F0F 0F0F', X'8F0F 0F0F 0F0F 0F0F'
; expect: [broadcast_b + 4*64] = X'5F5F 5F5F 5F5F 5F5F', X'FFFF 0F0F FFFF 0F0F'
; expect: [broadcast_both] = X'0FFF 0FFF 0FFF 0FFF', X'0FFF 0FFF 0FFF 0FFF'
; expect: [broadcast_both + 2*64] = X'0FFF 0FFF 0FFF 0FFF'
; expect: [broadcast_both + 3*64] = X'0FFF 0FFF 0FFF 0FFF'
; expect: [broadcast_both + 4*64] = X'0FFF 0FFF 0FFF 0FFF'
; expect: [broadcast_both + 5*64] = X'0FFF 0FFF 0FFF 0FFF'
; expect: [where_ones] = X'0123 4567 89AB CDEF', 9.0, X'FFFF FFFF FFFF FFFE'
; expect: [where_ones + 3*64] = X'FFFF FFFF FFFF FFFF', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'FFFF FFFF FFFF FFFF', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'DDDD DDDD DDDD DDDD', X'FFFF 0000 FFFF FFFF'
; expect: [offset_sources] = X'FFFF FFFF FFFF FFFF', X'7FFF FFFF FFFF FFFF'
; expect: [offset_sources + 2*64] = X'CCCC CCCC CCCC CCCD'
; expect: [offset_sources + 3*64] = X'FFFF 5555 5555 FFFF'
; expect: [offset_sources + 4*64] = X'FFFF FFFF FFFF FFFF'
; expect: [offset_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [offset_result] = 9.0, 9.0, X'FFFF FFFF FFFF FFFF'
; expect: [offset_result + 3*64] = X'FFFF FFFF FFFF FFFE', 9.0, 9.0
; expect: [short_sources] = X'0123 4567 89AB CDEF', X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 2*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 3*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 4*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ORNV
; expect: [chain] = 1.0, X'FFF3 4567 89AB CDEF', X'FFF3 F5F7 F9FB FDFF'
; expect: [chain + 3*64] = X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF'
; expect: [chain + 5*64] = X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
