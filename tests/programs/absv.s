; ABSV: C := |A|

        .include "unary.inc"

        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    ABSV
; expect: [plain] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
; expect: [broadcast] = 8.0, 8.0, 8.0, 8.0, 8.0, 8.0
; expect: [where_ones] = 2.25, 9.0, 16.0, 0.5, 9.0, 9.0
; expect: [where_zeros] = 9.0, 2.25, 9.0, 9.0, 100.0, 0.75
; expect: [offset_source] = 16.0, 0.5, 100.0, 0.75, 0.0, 0.0
; expect: [offset_result] = 9.0, 9.0, 2.25, 16.0, 9.0, 9.0
; expect: [short_source] = 2.25, 2.25, 16.0, 0.5, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap ABSV
; expect: [chain] = 2.25, 2.25, 2.25, 2.25, 2.25, 2.25, 2.25

        signs   ABSV
; expect: [negated] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
; expect: [magnitudes] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75
; expect: [negative] = 2.25, 2.25, 16.0, 0.5, 100.0, 0.75

        .data
odd_a:  .word   5, -7, X'0000 8000 0000 0000', 0.0, X'7000 0000 0000 0000'
        .word   X'6FFF 8000 0000 0000'
        .code
        specials ABSV, 6
; expect: [odd] = 5, 7, X'0001 4000 0000 0000', 0.0, X'7000 0000 0000 0000'
; expect: [odd + 5*64] = X'7000 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0032 0000'
; expect-warning: recurrence
