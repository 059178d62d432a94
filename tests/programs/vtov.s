; VTOV: C := A

        .include "unary.inc"

        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    VTOV
; expect: [plain] = 2.25, -2.25, 16.0, -0.5, 100.0, 0.75
; expect: [broadcast] = 8.0, 8.0, 8.0, 8.0, 8.0, 8.0
; expect: [where_ones] = 2.25, 9.0, 16.0, -0.5, 9.0, 9.0
; expect: [where_zeros] = 9.0, -2.25, 9.0, 9.0, 100.0, 0.75
; expect: [offset_source] = 16.0, -0.5, 100.0, 0.75, 0.0, 0.0
; expect: [offset_result] = 9.0, 9.0, -2.25, 16.0, 9.0, 9.0
; expect: [short_source] = 2.25, -2.25, 16.0, -0.5, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap VTOV
; expect: [chain] = 2.25, 2.25, 2.25, 2.25, 2.25, 2.25, 2.25

        signs   VTOV
; expect: [negated] = -2.25, 2.25, -16.0, 0.5, -100.0, -0.75
; expect: [magnitudes] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
; expect: [negative] = -2.25, -2.25, -16.0, -0.5, -100.0, -0.75

        .data
odd_a:  .word   5, X'8FFF 1234 5678 9ABC', X'7ABC 0000 0000 0001', 0
        .word   X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'
        .code
        specials VTOV, 6
; expect: [odd] = 5, X'8FFF 1234 5678 9ABC', X'7ABC 0000 0000 0001', 0
; expect: [odd + 4*64] = X'0000 8000 0000 0000', X'6FFF 7FFF FFFF FFFF'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: recurrence
