; DIVUS: C := upper(A / B), where both are present

        .include "sparse.inc"

        uses    DIVUS
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
; expect: [plain] = X'FFCE 6666 6666 6666', 1.0, 9.0
; expect: [given] = X'FFCE 6666 6666 6666', X'7000 0000 0000 0000', X'7000 0000 0000 0000'
; expect: [given + 3*64] = X'7000 0000 0000 0000', 9.0, 9.0
; expect: [given_few] = X'FFCE 9999 9999 999A', 0.0, 9.0
; expect: [short_order] = X'FFCE 6666 6666 6666', 9.0
; expect: [short_packed] = X'FFCE 6666 6666 6666', X'FFCF 71C7 1C71 C71C', 9.0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: r0 = 0

; Of numbers that are not normalised U has more digits than S.
        .data
seven:  .word   X'0000 0000 0000 0007'
three:  .word   X'0000 0000 0000 0003'
        .bitvector present, 1, "1"
        .code
        descriptor va, seven, 1
        descriptor vb, three, 1
        descriptor vx, present, 1
        descriptor vy, present, 1
        into_sparse unnormalised
        DIVUS   [va, vx], [vb, vy], [to], [order]
; expect: [unnormalised] = X'FFD3 4AAA AAAA AAAA', 9.0

        EXIT
; expect-flags: X'0000 0000 0052 0000'
; expect-warning: zero-length
