; PACKV: C := low 16 bits of A as exponents, coefficients of B

        .include "binary.inc"

        .data
a:      .word   -46, -45, 3, 0, X'1234 0000 0000 8000', 7
b:      .word   X'1111 4000 0000 0000', X'2222 4000 0000 0000', -5, 6, 7
        .word   X'3333 2000 0000 0000'
scalars:
        .word   -46, X'5555 4000 0000 0001'
        .bitvector z, n, "101100"
        .code

        uses    PACKV
; expect: [plain] = 1.0, 2.0, X'0003 FFFF FFFF FFFB', 6
; expect: [plain + 4*64] = X'8000 0000 0000 0007', X'0007 2000 0000 0000'
; expect: [broadcast_a] = 1.0, 1.0, X'FFD2 FFFF FFFF FFFB'
; expect: [broadcast_a + 3*64] = X'FFD2 0000 0000 0006'
; expect: [broadcast_a + 4*64] = X'FFD2 0000 0000 0007'
; expect: [broadcast_a + 5*64] = X'FFD2 2000 0000 0000'
; expect: [broadcast_b] = X'FFD2 4000 0000 0001', X'FFD3 4000 0000 0001'
; expect: [broadcast_b + 2*64] = X'0003 4000 0000 0001'
; expect: [broadcast_b + 3*64] = X'0000 4000 0000 0001'
; expect: [broadcast_b + 4*64] = X'8000 4000 0000 0001'
; expect: [broadcast_b + 5*64] = X'0007 4000 0000 0001'
; expect: [broadcast_both] = X'FFD2 4000 0000 0001', X'FFD2 4000 0000 0001'
; expect: [where_ones] = 1.0, 9.0, X'0003 FFFF FFFF FFFB', 6, 9.0, 9.0
; expect: [where_zeros] = 9.0, 2.0, 9.0, 9.0, X'8000 0000 0000 0007'
; expect: [where_zeros + 5*64] = X'0007 2000 0000 0000'
; zero words follow
; expect: [offset_sources] = X'FFD3 FFFF FFFF FFFB', X'0003 0000 0000 0006', 7
; expect: [offset_sources + 3*64] = X'8000 2000 0000 0000'
; expect: [offset_sources + 4*64] = X'0007 0000 0000 0000'
; expect: [offset_sources + 5*64] = 0
; expect: [offset_result] = 9.0, 9.0, 2.0, X'0003 FFFF FFFF FFFB', 9.0, 9.0
; expect: [short_sources] = 1.0, 2.0, X'0003 0000 0000 0000', 0, 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap PACKV
; expect: [chain] = 1.0, X'0000 4000 0000 0000', X'0000 4000 0000 0000'
; expect: [chain + 3*64] = X'0000 FFFF FFFF FFFB', X'FFFB 0000 0000 0006'
; expect: [chain + 5*64] = X'0006 0000 0000 0007', X'0007 2000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
