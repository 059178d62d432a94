; TRUV: C := A cut to integers towards zero, exponent 0

        .include "unary.inc"

        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    TRUV
; expect: [plain] = 2, -2, 16, 0, 100, 0
; expect: [broadcast] = 8, 8, 8, 8, 8, 8
; expect: [where_ones] = 2, 9.0, 16, 0, 9.0, 9.0
; expect: [where_zeros] = 9.0, -2, 9.0, 9.0, 100, 0
; expect: [offset_source] = 16, 0, 100, 0, 0.0, 0.0
; expect: [offset_result] = 9.0, 9.0, -2, 16, 9.0, 9.0
; expect: [short_source] = 2, -2, 16, 0, 0.0, 0.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap TRUV
; expect: [chain] = 2.25, 2, 2, 2, 2, 2, 2

        signs   TRUV
; expect: [negated] = -2, 2, -16, 0, -100, 0
; expect: [magnitudes] = 2, 2, 16, 0, 100, 0
; expect: [negative] = -2, -2, -16, 0, -100, 0

        .data
odd_a:  .word   5, -7, X'FFFF 0000 0000 0005', 0.0, X'7000 0000 0000 0000'
        .word   X'6FFF 7FFF FFFF FFFF'
        .code
        specials TRUV, 6
; expect: [odd] = 5, -7, 2, 0.0, X'7000 0000 0000 0000', X'6FFF 7FFF FFFF FFFF'

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: recurrence
