; NORV: C := NOT (A OR B)

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

        uses    NORV
; expect: [plain] = 0, 0, X'FFFF FFFF FFFF FFFE', X'7FFF FFFF FFFF FFFE'
; expect: [plain + 4*64] = X'8888 8888 8888 8888', 65535
; expect: [broadcast_a] = X'0100 4500 8900 CD00', X'F000 F000 F000 F000'
; expect: [broadcast_a + 2*64] = X'FF00 FF00 FF00 FF00', X'7F00 FF00 FF00 FF00'
; expect: [broadcast_a + 4*64] = X'CC00 CC00 CC00 CC00', X'FF00 0000 0000 FF00'
; expect: [broadcast_b] = X'0E0C 0A08 0604 0200', 0, X'0F0F 0F0F 0F0F 0F0F'
; expect: [broadcast_b + 3*64] = X'0F0F 0F0F 0F0F 0F0E', X'0A0A 0A0A 0A0A 0A0A'
; expect: [broadcast_b + 5*64] = 16557098929935
; expect: [broadcast_both] = X'0F00 0F00 0F00 0F00', X'0F00 0F00 0F00 0F00'
; expect: [broadcast_both + 2*64] = X'0F00 0F00 0F00 0F00'
; expect: [broadcast_both + 3*64] = X'0F00 0F00 0F00 0F00'
; expect: [broadcast_both + 4*64] = X'0F00 0F00 0F00 0F00'
; expect: [broadcast_both + 5*64] = X'0F00 0F00 0F00 0F00'
; expect: [where_ones] = 0, 9.0, X'FFFF FFFF FFFF FFFE', X'7FFF FFFF FFFF FFFE'
; expect: [where_ones + 4*64] = 9.0, 9.0
; expect: [where_zeros] = 9.0, 0, 9.0, 9.0, X'8888 8888 8888 8888', 65535
; expect: [offset_sources] = 0, X'7FFF FFFF FFFF FFFF', X'4CCC CCCC CCCC CCCC'
; expect: [offset_sources + 3*64] = X'AAAA 0000 0000 AAAA', -4294901761
; expect: [offset_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [offset_result] = 9.0, 9.0, 0, X'FFFF FFFF FFFF FFFE', 9.0, 9.0
; expect: [short_sources] = 0, 0, X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 3*64] = X'7FFF FFFF FFFF FFFE'
; expect: [short_sources + 4*64] = X'FFFF FFFF FFFF FFFF'
; expect: [short_sources + 5*64] = X'FFFF FFFF FFFF FFFF'
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap NORV
; expect: [chain] = 1.0, X'0021 0567 89AB CDEF', X'F0D0 F090 7050 3010'
; expect: [chain + 3*64] = X'0F2F 0F6F 8FAF CFEE', X'70D0 F090 7050 3011'
; expect: [chain + 5*64] = X'8C0C 0C4C 8C8C CCCC', X'73F3 0000 0000 3333'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
