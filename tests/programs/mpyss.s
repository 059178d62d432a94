; MPYSS: C := significant(A x B), where both are present

        .include "sparse.inc"

        uses    MPYSS
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
; expect: [plain] = 10.0, 20.25, 9.0
; expect: [given] = 10.0, 0.0, 0.0, 0.0, 9.0, 9.0
; expect: [given_few] = -10.0, 0.0, 9.0
; expect: [short_order] = 10.0, 9.0
; expect: [short_packed] = 10.0, 4.5, 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: r0 = 0

; The result lies over A, from its second element on.
        .data
chain:  .word   1.0, -2.0, 4.5, 9.0
        .code
        sparse_operands
        descriptor va, chain, 3
        EX      to, chain + 64
        EX      order, plain_order
        MPYSS   [va, vx], [vb, vy], [to], [order]
; expect: [chain] = 1.0, 10.0, 20.25, 9.0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
