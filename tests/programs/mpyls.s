; MPYLS: C := lower(A x B), where both are present

        .include "sparse.inc"

        uses    MPYLS
; expect-bits: [plain_order] = 10010011
; expect: [plain_lengths] = 2, 6
; expect-bits: [wanted] = 1100101
; expect: [given_lengths] = 4, 7
; expect: [given_few_lengths] = 2, 3
; expect-bits: [short_order_order] = 10000011
; expect: [short_order_lengths] = 1, 6
; expect-bits: [short_packed_order] = 10010011
; expect: [short_packed_lengths] = 2, 6
; expect: [nothing_order] = X'FFFF FFFF FFFF FFFF'
; expect: [nothing_lengths] = 0, 0
; expect: [plain] = X'FFA7 0000 0000 0000', X'FFA8 0000 0000 0000', 9.0
; expect: [given] = X'FFA7 0000 0000 0000', 0.0, 0.0, 0.0, 9.0, 9.0
; expect: [given_few] = X'FFA6 0000 0000 0000', 0.0, 9.0
; expect: [short_order] = X'FFA7 0000 0000 0000', 9.0
; expect: [short_packed] = X'FFA7 0000 0000 0000', X'FFA6 0000 0000 0000', 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
