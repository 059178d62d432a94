; NANDV: C := NOT (A AND B)

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

        uses    NANDV
; expect: [plain] = X'FFFF FFFF FFFF FFFF', X'F0F0 F0F0 F0F0 F0F0'
; expect: [plain + 2*64] = X'FFFF FFFF FFFF FFFF', X'7FFF FFFF FFFF FFFF'
; expect: [plain + 4*64] = X'EEEE EEEE EEEE EEEE', X'FFFF FFFF 0000 FFFF'
; expect: [broadcast_a] = X'FF23 FF67 FFAB FFEF', X'FFF0 FFF0 FFF0 FFF0'
; expect: [broadcast_a + 2*64] = X'FFFF FFFF FFFF FFFE', X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_a + 4*64] = X'FFCC FFCC FFCC FFCC', X'FFFF FF00 FF00 FFFF'
; expect: [broadcast_b] = X'FFDF BF9F 7F5F 3F1F', X'0F0F 0F0F 0F0F 0F0F'
; expect: [broadcast_b + 2*64] = X'FFFF FFFF FFFF FFFF', X'7FFF FFFF FFFF FFFF'
; expect: [broadcast_b + 4*64] = X'AFAF AFAF AFAF AFAF', X'0F0F FFFF 0F0F FFFF'
; expect: [broadcast_both] = X'FF0F FF0F FF0F FF0F', X'FF0F FF0F FF0F FF0F'
; expect: [broadcast_both + 2*64] = X'FF0F FF0F FF0F FF0F'
; expect: [broadcast_both + 3*64] = X'FF0F FF0F FF0F FF0F'
; expect: [broadcast_both + 4*64] = X'FF0F FF0F FF0F FF0F'
; expect: [broadcast_both + 5*64] = X'FF0F FF0F FF0F FF0F'
; expect: [where_ones] = X'FFFF FFFF FFFF FFFF', 9.0, X'FFFF FFFF FFFF FFFF'
; expect: [where_ones + 3*64] = X'7FFF FFFF FFFF FFFF', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'F0F0 F0F0 F0F0 F0F0', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'EEEE EEEE EEEE EEEE', X'FFFF FFFF 0000 FFFF'
; expect: [offset_sources] = X'FFFF FFFF FFFF FFFE', X'FFFF FFFF FFFF FFFF'
; expect: [offset_sources + 2*64] = X'FFFF FFFF FFFF FFFE'
; expect: [offset_sources + 3*64] = X'FFFF AAAA AAAA FFFF'
; expect: [offset_sources + 4*64] = X'FFFF FFFF FFFF FFFF'
; expect: [offset_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [offset_result] = 9.0, 9.0, X'F0F0 F0F0 F0F0 F0F0'
; expect: [offset_result + 3*64] = X'FFFF FFFF FFFF FFFF', 9.0, 9.0
; expect: [short_sources] = X'FFFF FFFF FFFF FFFF', X'F0F0 F0F0 F0F0 F0F0'
; expect: [short_sources + 2*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 3*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 4*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap NANDV
; expect: [chain] = 1.0, X'012F FFFF FFFF FFFF', X'FEF0 F0F0 F0F0 F0F0'
; expect: [chain + 3*64] = X'FFFF FFFF FFFF FFFF', X'7FFF FFFF FFFF FFFF'
; expect: [chain + 5*64] = X'CCCC CCCC CCCC CCCC', X'FFFF 3333 3333 FFFF'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
