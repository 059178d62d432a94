; MPYLV: C := lower(A x B)

        .include "binary.inc"

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
        .code

        uses    MPYLV
; expect: [plain] = X'FFA7 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [plain + 2*64] = X'FFA6 0000 0000 0000', X'FFA8 0000 0000 0000'
; expect: [plain + 4*64] = X'FFA3 0000 0000 0000', X'FFA7 0000 0000 0000'
; expect: [broadcast_a] = X'FFAA 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [broadcast_a + 2*64] = X'FFA8 0000 0000 0000', X'FFA9 0000 0000 0000'
; expect: [broadcast_a + 4*64] = X'FFA8 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [broadcast_b] = X'FFA2 0000 0000 0000', X'FFA2 0000 0000 0000'
; expect: [broadcast_b + 2*64] = X'FFA3 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [broadcast_b + 4*64] = X'FFA0 0000 0000 0000', X'FFA8 0000 0000 0000'
; expect: [broadcast_both] = X'FFA5 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [broadcast_both + 2*64] = X'FFA5 0000 0000 0000'
; expect: [broadcast_both + 3*64] = X'FFA5 0000 0000 0000'
; expect: [broadcast_both + 4*64] = X'FFA5 0000 0000 0000'
; expect: [broadcast_both + 5*64] = X'FFA5 0000 0000 0000'
; expect: [where_ones] = X'FFA7 0000 0000 0000', 9.0, X'FFA6 0000 0000 0000'
; expect: [where_ones + 3*64] = X'FFA8 0000 0000 0000', 9.0, 9.0
; expect: [where_zeros] = 9.0, X'FFA3 0000 0000 0000', 9.0, 9.0
; expect: [where_zeros + 4*64] = X'FFA3 0000 0000 0000', X'FFA7 0000 0000 0000'
; expect: [offset_sources] = X'FFA5 0000 0000 0000', X'FFA7 0000 0000 0000'
; expect: [offset_sources + 2*64] = X'FFA7 0000 0000 0000'
; expect: [offset_sources + 3*64] = X'FF9F 0000 0000 0000'
; expect: [offset_sources + 4*64] = X'FFAA 0000 0000 0000'
; expect: [offset_sources + 5*64] = X'FFA4 0000 0000 0000'
; expect: [offset_result] = 9.0, 9.0, X'FFA3 0000 0000 0000'
; expect: [offset_result + 3*64] = X'FFA6 0000 0000 0000', 9.0, 9.0
; expect: [short_sources] = X'FFA7 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [short_sources + 2*64] = X'FFA5 0000 0000 0000'
; expect: [short_sources + 3*64] = X'FFA6 0000 0000 0000'
; expect: [short_sources + 4*64] = X'FFA4 0000 0000 0000'
; expect: [short_sources + 5*64] = X'FFA4 0000 0000 0000'
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap MPYLV
; expect: [chain] = 1.0, X'FFA7 0000 0000 0000', X'FF78 0000 0000 0000'
; expect: [chain + 3*64] = X'FF4B 0000 0000 0000', X'FF1F 0000 0000 0000'
; expect: [chain + 5*64] = X'FEF2 0000 0000 0000', X'FEC1 0000 0000 0000'

        signs   MPYLV
; expect: [negated] = X'FFA6 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [negated + 2*64] = X'FFA6 0000 0000 0000', X'FFA8 0000 0000 0000'
; expect: [negated + 4*64] = X'FFA4 0000 0000 0000', X'FFA7 0000 0000 0000'
; expect: [magnitudes] = X'FFA7 0000 0000 0000', X'FFA4 0000 0000 0000'
; expect: [magnitudes + 2*64] = X'FFA6 0000 0000 0000', X'FFA8 0000 0000 0000'
; expect: [magnitudes + 4*64] = X'FFA4 0000 0000 0000', X'FFA8 0000 0000 0000'
; expect: [negative] = X'FFA6 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [negative + 2*64] = X'FFA6 0000 0000 0000', X'FFA8 0000 0000 0000'
; expect: [negative + 4*64] = X'FFA3 0000 0000 0000', X'FFA7 0000 0000 0000'
; expect: [negated_scalar] = X'FFA9 0000 0000 0000', X'FFA5 0000 0000 0000'
; expect: [negated_scalar + 2*64] = X'FFA7 0000 0000 0000'
; expect: [negated_scalar + 3*64] = X'FFA8 0000 0000 0000'
; expect: [negated_scalar + 4*64] = X'FFA7 0000 0000 0000'
; expect: [negated_scalar + 5*64] = X'FFA3 0000 0000 0000'

        .data
odd_a:  .word   6, 0.0, 1.0, X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        .word   X'9000 4000 0000 0000'
odd_b:  .word   7, 7, X'7000 0000 0000 0000', X'0000 8000 0000 0000', 8.0, 0.25
        .code
        specials MPYLV, 6
; expect: [odd] = 42, 0.0, X'7000 0000 0000 0000', 0, X'6FD4 4000 0000 0000'
; expect: [odd + 5*64] = 0.0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
