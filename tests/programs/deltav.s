; DELTAV: C(i) := normalised(A(i+1) - A(i))

        .include "unary.inc"

        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    DELTAV
; expect: [plain] = -4.5, 18.25, -16.5, 100.5, -99.25, -0.75
; expect: [broadcast] = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
; expect: [where_ones] = -4.5, 9.0, -16.5, 100.5, 9.0, 9.0
; expect: [where_zeros] = 9.0, 18.25, 9.0, 9.0, -99.25, -0.75
; expect: [offset_source] = -16.5, 100.5, -99.25, -0.75, 0.0, 0.0
; expect: [offset_result] = 9.0, 9.0, 18.25, -16.5, 9.0, 9.0
; expect: [short_source] = -4.5, 18.25, -16.5, 0.5, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap DELTAV
; expect: [chain] = 2.25, 13.75, -10.25, 2.25, 2.75, -1.75, 1.75

        signs   DELTAV
; expect: [negated] = 4.5, -18.25, 16.5, -100.5, 99.25, 0.75
; expect: [magnitudes] = 0.0, 13.75, -15.5, 99.5, -99.25, -0.75
; expect: [negative] = 0.0, -13.75, 15.5, -99.5, 99.25, 0.75

        .data
odd_a:  .word   5, 8, 8, 0.0, X'7000 0000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        .code
        specials DELTAV, 6
; expect: [odd] = 3.0, 0.0, -8.0, X'7000 0000 0000 0000'
; expect: [odd + 4*64] = X'7000 0000 0000 0000', X'6FFF 8000 0000 0001'

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: recurrence
