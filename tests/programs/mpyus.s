; MPYUS: C := upper(A x B), where both are present

        .include "sparse.inc"

        uses    MPYUS
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
; expect: [plain] = X'FFD6 2800 0000 0000', X'FFD7 2880 0000 0000', 9.0
; expect: [given] = X'FFD6 2800 0000 0000', 0.0, 0.0, 0.0, 9.0, 9.0
; expect: [given_few] = -10.0, 0.0, 9.0
; expect: [short_order] = X'FFD6 2800 0000 0000', 9.0
; expect: [short_packed] = X'FFD6 2800 0000 0000', X'FFD5 2400 0000 0000', 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
