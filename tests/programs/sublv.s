; SUBLV: C := lower(A - B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    SUBLV
; expect: [plain] = X'FFA6 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [plain + 2*64] = X'FFA5 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [plain + 4*64] = X'FFA4 0000 0000 0000', X'FFA9 0000 0000 0000'
; expect: [broadcast_a] = X'FFA6 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [broadcast_a + 2*64] = X'FFA6 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [broadcast_a + 4*64] = X'FFA6 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [broadcast_b] = X'FFA3 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [broadcast_b + 2*64] = X'FFA4 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [broadcast_b + 4*64] = X'FFA1 0000 0000 0000', X'FFA9 0000 0000 0000'
; expect: [broadcast_both] = X'FFA6 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [broadcast_both + 2*64] = X'FFA6 0000 0000 0000'
; expect: [broadcast_both + 3*64] = X'FFA6 0000 0000 0000'
; expect: [broadcast_both + 4*64] = X'FFA6 0000 0000 0000'
; expect: [broadcast_both + 5*64] = X'FFA6 0000 0000 0000'
; expect: [where_ones] = X'FFA6 0000 0000 0000', 9.0, X'FFA5 0000 0000 0000'
; expect: [where_ones + 3*64] = X'FFA5 0000 0000 0000', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'FFA4 0000 0000 0000', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'FFA4 0000 0000 0000', X'FFA9 0000 0000 0000'
; expect: [offset_sources] = X'FFA4 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [offset_sources + 2*64] = X'FFA5 0000 0000 0000'
; expect: [offset_sources + 3*64] = X'FFA1 0000 0000 0000'
; expect: [offset_sources + 4*64] = X'FFA9 0000 0000 0000', 0.0
; expect: [offset_result] = 9.0, 9.0, X'FFA4 0000 0000 0000'
; expect: [offset_result + 3*64] = X'FFA5 0000 0000 0000', 9.0, 9.0
; expect: [short_sources] = X'FFA6 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [short_sources + 2*64] = X'FFA4 0000 0000 0000'
; expect: [short_sources + 3*64] = X'FFA5 0000 0000 0000', 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap SUBLV
; expect: [chain] = 1.0, X'FFA6 0000 0000 0000', X'FFA2 0000 0000 0000'
; expect: [chain + 3*64] = X'FFA4 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [chain + 5*64] = X'FFA4 0000 0000 0000', X'FFA1 0000 0000 0000'

        signs   SUBLV
; expect: [negated] = X'FFA6 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [negated + 2*64] = X'FFA4 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [negated + 4*64] = X'FFA4 0000 0000 0000', X'FFA9 0000 0000 0000'
; expect: [magnitudes] = X'FFA6 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [magnitudes + 2*64] = X'FFA4 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [magnitudes + 4*64] = X'FFA4 0000 0000 0000', X'FFA9 0000 0000 0000'
; expect: [negative] = X'FFA6 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [negative + 2*64] = X'FFA4 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [negative + 4*64] = X'FFA4 0000 0000 0000', X'FFA9 0000 0000 0000'
; expect: [negated_scalar] = X'FFA7 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [negated_scalar + 2*64] = X'FFA5 0000 0000 0000'
; expect: [negated_scalar + 3*64] = X'FFA6 0000 0000 0000'
; expect: [negated_scalar + 4*64] = X'FFA6 0000 0000 0000'
; expect: [negated_scalar + 5*64] = X'FFA5 0000 0000 0000'

        .data
odd_a:  .word   5, 0.0, 1.0, 3.0, X'6FFF 7FFF FFFF FFFF'
        .word   X'0010 0000 0000 0000'
odd_b:  .word   3, 7, X'7000 0000 0000 0000', -3.0, X'6FFF 7FFF FFFF FFFF', 1.0
        .code
        specials SUBLV, 6
; expect: [odd] = X'FFD1 0000 0000 0000', X'FFD1 0000 0000 0000'
; expect: [odd + 2*64] = X'7000 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [odd + 4*64] = X'6FD0 0000 0000 0000', 65535.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
