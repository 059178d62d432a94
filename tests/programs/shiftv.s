; SHIFTV: C := A shifted by B: left circular, or right (negative) with the
; sign extended

        .include "binary.inc"

        .data
a:      .word   X'0123 4567 89AB CDEF', X'FFFF FFFF FFFF FFFF'
        .word   X'0000 0000 0000 0000', X'8000 0000 0000 0001'
        .word   X'5555 5555 5555 5555', X'FFFF 0000 FFFF 0000'
b:      .word   4, -4, 63, -1, -64, 64
scalars:
        .word   X'8123 4567 89AB CDEF', -100
        .bitvector z, n, "101100"
        .code

        uses    SHIFTV
; expect: [plain] = X'1234 5678 9ABC DEF0', X'FFFF FFFF FFFF FFFF', 0
; expect: [plain + 3*64] = X'C000 0000 0000 0000', 0, X'FFFF 0000 FFFF 0000'
; expect: [broadcast_a] = X'1234 5678 9ABC DEF8', X'F812 3456 789A BCDE'
; expect: [broadcast_a + 2*64] = X'C091 A2B3 C4D5 E6F7', X'C091 A2B3 C4D5 E6F7'
; expect: [broadcast_a + 4*64] = X'FFFF FFFF FFFF FFFF', X'8123 4567 89AB CDEF'
; expect: [broadcast_b] = 0, X'FFFF FFFF FFFF FFFF', 0, X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_b + 4*64] = 0, X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_both] = X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_both + 2*64] = X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_both + 3*64] = X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_both + 4*64] = X'FFFF FFFF FFFF FFFF'
; expect: [broadcast_both + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [where_ones] = X'1234 5678 9ABC DEF0', 9.0, 0, X'C000 0000 0000 0000'
; expect: [where_ones + 4*64] = 9.0, 9.0
; expect: [where_zeros] = 9.0, X'FFFF FFFF FFFF FFFF', 9.0, 9.0, 0
; expect: [where_zeros + 5*64] = X'FFFF 0000 FFFF 0000'
; expect: [offset_sources] = X'FFFF FFFF FFFF FFFF', 0, X'FFFF FFFF FFFF FFFF'
; expect: [offset_sources + 3*64] = X'5555 5555 5555 5555'
; expect: [offset_sources + 4*64] = X'FFFF 0000 FFFF 0000', 0
; expect: [offset_result] = 9.0, 9.0, X'FFFF FFFF FFFF FFFF', 0, 9.0, 9.0
; expect: [short_sources] = X'1234 5678 9ABC DEF0', X'FFFF FFFF FFFF FFFF', 0
; expect: [short_sources + 3*64] = X'8000 0000 0000 0001', 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap SHIFTV
; expect: [chain] = 1.0, X'FD24 0000 0000 000F', 1.0, X'7FE9 2000 0000 0000'
; expect: [chain + 4*64] = X'3FF4 9000 0000 0000', 0, 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
