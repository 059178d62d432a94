; EXPV: C := exponent of A, as an integer

        .include "unary.inc"

        .data
a:      .word   2.25, -2.25, 16.0, -0.5, 100.0, 0.75
scalars:
        .word   8.0, 0.0
        .bitvector z, n, "101100"
        .code

        uses    EXPV
; expect: [plain] = -45, -45, -42, -48, -40, -47
; expect: [broadcast] = -43, -43, -43, -43, -43, -43
; expect: [where_ones] = -45, 9.0, -42, -48, 9.0, 9.0
; expect: [where_zeros] = 9.0, -45, 9.0, 9.0, -40, -47
; expect: [offset_source] = -42, -48, -40, -47, -32768, -32768
; expect: [offset_result] = 9.0, 9.0, -45, -42, 9.0, 9.0
; expect: [short_source] = -45, -45, -42, -48, -32768, -32768
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0

        overlap EXPV
; expect: [chain] = 2.25, -45, 0, 0, 0, 0, 0

        signs   EXPV
; expect: [negated] = -45, -45, -43, -47, -40, -47
; expect: [magnitudes] = -45, -45, -42, -47, -40, -47
; expect: [negative] = -45, -45, -43, -48, -40, -47

        .data
odd_a:  .word   5, X'6FFF 7FFF FFFF FFFF', X'9000 4000 0000 0000', 0.0
        .word   X'7000 0000 0000 0000', X'FFFF 0000 0000 0005'
        .code
        specials EXPV, 6
; expect: [odd] = 0, 28671, -28672, -32768, 28672, -1

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: recurrence
