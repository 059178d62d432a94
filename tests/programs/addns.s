; ADDNS: C := normalised(A + B), where one is present

        .include "sparse.inc"

        uses    ADDNS
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

; The result lies one word after A: elements are read that have been stored.
; Its order vector takes the place of X.
        .data
chain:  .word   1.0, -2.0, 4.5, 9.0, 9.0, 9.0
        .bitvector chain_order, 6, "110100"
        .code
        sparse_operands
        descriptor va, chain, 3
        descriptor vx, chain_order, 6
        EX      to, chain + 64
        ADDNS   [va, vx], [vb, vy], [to], [vx]
; expect: [chain] = 1.0, 11.0, 11.0, -3.0, 15.5, -0.25
; expect-bits: [chain_order] = 11110100

; Of the sums of neighbours every third one; they lie upon their order vector,
; which was read before.
        .data
packed: .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .bitvector all, 6, "111111"
        .bitvector third, 6, "100100"
        .space  1
        .code
        sparse_operands
        descriptor va, packed, 6
        descriptor vx, all, 6
        descriptor vb, packed + 64, 5
        descriptor vy, all, 5
        descriptor vz, third, 6
        EX      to, third
        ADDNS   |[va, vx]|, |[vb, vy]|, [to] ? [vz]
; expect: [third] = 3.0, 9.0

        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
; expect-warning: recurrence
