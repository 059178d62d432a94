; ADJSV: C := A, its coefficients shifted left by B, no further than
; normalised, or right (negative)

        .include "binary.inc"

        .data
a:      .word   5, -13, 1.0, 12, 100, 7
b:      .word   3, -2, 5, 1, -3, 0
scalars:
        .word   6, -1
        .bitvector z, n, "101100"
        .code

        uses    ADJSV
; expect: [plain] = X'FFFD 0000 0000 0028', X'0002 FFFF FFFF FFFC', 1.0
; expect: [plain + 3*64] = X'FFFF 0000 0000 0018', X'0003 0000 0000 000C', 7
; expect: [broadcast_a] = X'FFFD 0000 0000 0030', X'0002 0000 0000 0001'
; expect: [broadcast_a + 2*64] = X'FFFB 0000 0000 00C0'
; expect: [broadcast_a + 3*64] = X'FFFF 0000 0000 000C'
; expect: [broadcast_a + 4*64] = X'0003 0000 0000 0000', 6
; expect: [broadcast_b] = X'0001 0000 0000 0002', X'0001 FFFF FFFF FFF9'
; expect: [broadcast_b + 2*64] = X'FFD3 2000 0000 0000'
; expect: [broadcast_b + 3*64] = X'0001 0000 0000 0006'
; expect: [broadcast_b + 4*64] = X'0001 0000 0000 0032'
; expect: [broadcast_b + 5*64] = X'0001 0000 0000 0003'
; expect: [broadcast_both] = X'0001 0000 0000 0003', X'0001 0000 0000 0003'
; expect: [where_ones] = X'FFFD 0000 0000 0028', 9.0, 1.0
; expect: [where_ones + 3*64] = X'FFFF 0000 0000 0018', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'0002 FFFF FFFF FFFC', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'0003 0000 0000 000C', 7
; machine zeros follow, which are counts of 0
; expect: [offset_sources] = X'FFFB FFFF FFFF FE60', 1.0, X'0003 0000 0000 0001'
; expect: [offset_sources + 3*64] = 100, 7, 0.0
; expect: [offset_result] = 9.0, 9.0, X'0002 FFFF FFFF FFFC', 1.0, 9.0, 9.0
; expect: [short_sources] = X'FFFD 0000 0000 0028', X'0002 FFFF FFFF FFFC', 1.0
; expect: [short_sources + 3*64] = 12, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ADJSV
; expect: [chain] = 1.0, 1.0, X'FFD4 1000 0000 0000', 1.0, 1.0
; expect: [chain + 5*64] = X'FFD5 0800 0000 0000', X'FFD5 0800 0000 0000'

        signs   ADJSV
; expect: [negated] = X'FFFD FFFF FFFF FFD8', X'0002 0000 0000 0003', -1.0
; expect: [negated + 3*64] = X'FFFF FFFF FFFF FFE8'
; expect: [negated + 4*64] = X'0003 FFFF FFFF FFF3', -7
; expect: [magnitudes] = X'FFFD 0000 0000 0028', X'FFFE 0000 0000 0034', 1.0
; expect: [magnitudes + 3*64] = X'FFFF 0000 0000 0018'
; expect: [magnitudes + 4*64] = X'FFFD 0000 0000 0320', 7
; expect: [negative] = X'FFFD FFFF FFFF FFD8', X'0002 FFFF FFFF FFFC', -1.0
; expect: [negative + 3*64] = X'FFFF FFFF FFFF FFE8'
; expect: [negative + 4*64] = X'0003 FFFF FFFF FFF3', -7
; expect: [negated_scalar] = X'FFFD FFFF FFFF FFD0', X'0002 FFFF FFFF FFFE'
; expect: [negated_scalar + 2*64] = X'FFFB FFFF FFFF FF40'
; expect: [negated_scalar + 3*64] = X'FFFF FFFF FFFF FFF4'
; expect: [negated_scalar + 4*64] = X'0003 FFFF FFFF FFFF', -6

        .data
odd_a:  .word   X'7123 0000 0000 0001', X'6FFF 0000 0000 0005', 5
odd_b:  .word   1, -1, X'7000 0000 0000 0003'
        .code
        specials ADJSV, 3
; expect: [odd] = X'7000 0000 0000 0000', X'7000 0000 0000 0000'
; expect: [odd + 2*64] = X'FFFD 0000 0000 0028'

        EXIT
; expect-flags: X'0000 0000 0032 0000'
