; ADDUS: C := upper(A + B), where one is present

        .include "sparse.inc"

        uses    ADDUS
; expect-bits: [plain_order] = 11110111
; expect: [plain_lengths] = 5, 6
; expect-bits: [wanted] = 1100101
; expect: [given_lengths] = 4, 7
; expect: [given_few_lengths] = 2, 3
; expect-bits: [short_order_order] = 11110011
; expect: [short_order_lengths] = 4, 6
; expect-bits: [short_packed_order] = 11110111
; expect: [short_packed_lengths] = 5, 6
; expect: [nothing_order] = X'FFFF FFFF FFFF FFFF'
; expect: [nothing_lengths] = 0, 0
; expect: [plain] = 11.0, -2.0, -3.0, 9.0, -0.25, 9.0
; expect: [given] = 11.0, -2.0, 0.0, 0.0, 9.0, 9.0
; expect: [given_few] = 9.0, 3.0, 9.0
; expect: [short_order] = 11.0, -2.0, -3.0, 4.5, 9.0
; expect: [short_packed] = 11.0, -2.0, -3.0, 4.5, -0.25, 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
