; ADJEV: C := A with the exponents B, its coefficients shifted to suit;
; indefinite where one does not fit

        .include "binary.inc"

        .data
a:      .word   5, -13, 1.0, 12, 100, 7
b:      .word   -3, 2, 0, -1, 3, 0
scalars:
        .word   6, 1
        .bitvector z, n, "101100"
        .code

        uses    ADJEV
; expect: [plain] = X'FFFD 0000 0000 0028', X'0002 FFFF FFFF FFFC', 1
; expect: [plain + 3*64] = X'FFFF 0000 0000 0018', X'0003 0000 0000 000C', 7
; expect: [broadcast_a] = X'FFFD 0000 0000 0030', X'0002 0000 0000 0001', 6
; expect: [broadcast_a + 3*64] = X'FFFF 0000 0000 000C'
; expect: [broadcast_a + 4*64] = X'0003 0000 0000 0000', 6
; expect: [broadcast_b] = X'0001 0000 0000 0002', X'0001 FFFF FFFF FFF9'
; expect: [broadcast_b + 2*64] = X'0001 0000 0000 0000'
; expect: [broadcast_b + 3*64] = X'0001 0000 0000 0006'
; expect: [broadcast_b + 4*64] = X'0001 0000 0000 0032'
; expect: [broadcast_b + 5*64] = X'0001 0000 0000 0003'
; expect: [broadcast_both] = X'0001 0000 0000 0003', X'0001 0000 0000 0003'
; expect: [where_ones] = X'FFFD 0000 0000 0028', 9.0, 1
; expect: [where_ones + 3*64] = X'FFFF 0000 0000 0018', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'0002 FFFF FFFF FFFC', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'0003 0000 0000 000C', 7
; machine zeros follow, which are exponents of 0
; expect: [offset_sources] = -13, X'FFFF 0000 0000 0002', X'0003 0000 0000 0001'
; expect: [offset_sources + 3*64] = 100, 7, 0.0
; expect: [offset_result] = 9.0, 9.0, X'0002 FFFF FFFF FFFC', 1, 9.0, 9.0
; expect: [short_sources] = X'FFFD 0000 0000 0028', X'0002 FFFF FFFF FFFC', 1
; expect: [short_sources + 3*64] = 12, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ADJEV
; expect: [chain] = 1.0, X'FFFD 0000 0000 0008', X'0002 0000 0000 0000', 0
; expect: [chain + 4*64] = X'FFFF 0000 0000 0000', X'0003 0000 0000 0000', 0

        signs   ADJEV
; expect: [negated] = X'FFFD FFFF FFFF FFD8', X'0002 0000 0000 0003', -1
; expect: [negated + 3*64] = X'FFFF FFFF FFFF FFE8'
; expect: [negated + 4*64] = X'0003 FFFF FFFF FFF3', -7
; expect: [magnitudes] = X'0003 0000 0000 0000', X'0002 0000 0000 0003', 1
; expect: [magnitudes + 3*64] = X'0001 0000 0000 0006'
; expect: [magnitudes + 4*64] = X'0003 0000 0000 000C', 7
; expect: [negative] = X'FFFD FFFF FFFF FFD8', X'0002 FFFF FFFF FFFC', -1
; expect: [negative + 3*64] = X'FFFF FFFF FFFF FFE8'
; expect: [negative + 4*64] = X'0003 FFFF FFFF FFF3', -7
; expect: [negated_scalar] = X'FFFD FFFF FFFF FFD0', X'0002 FFFF FFFF FFFE', -6
; expect: [negated_scalar + 3*64] = X'FFFF FFFF FFFF FFF4'
; expect: [negated_scalar + 4*64] = X'0003 FFFF FFFF FFFF'
; expect: [negated_scalar + 5*64] = -6

        .data
odd_a:  .word   X'7123 0000 0000 0001', 5, X'8123 0000 0000 0005'
odd_b:  .word   1, -47, 5
        .code
        specials ADJEV, 3
; expect: [odd] = X'7000 0000 0000 0000', X'7000 0000 0000 0000', 0.0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
