; ADDLS: C := lower(A + B), where one is present

        .include "sparse.inc"

        uses    ADDLS
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
; expect: [plain] = X'FFA6 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [plain + 2*64] = X'FFA4 0000 0000 0000', X'FFA6 0000 0000 0000'
; expect: [plain + 4*64] = X'FFA0 0000 0000 0000', 9.0
; expect: [given] = X'FFA6 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [given + 2*64] = 0.0, 0.0, 9.0, 9.0
; expect: [given_few] = X'FFA6 0000 0000 0000', X'FFA4 0000 0000 0000', 9.0
; expect: [short_order] = X'FFA6 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [short_order + 2*64] = X'FFA4 0000 0000 0000'
; expect: [short_order + 3*64] = X'FFA5 0000 0000 0000', 9.0
; expect: [short_packed] = X'FFA6 0000 0000 0000', X'FFA3 0000 0000 0000'
; expect: [short_packed + 2*64] = X'FFA4 0000 0000 0000'
; expect: [short_packed + 3*64] = X'FFA5 0000 0000 0000'
; expect: [short_packed + 4*64] = X'FFA0 0000 0000 0000', 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
