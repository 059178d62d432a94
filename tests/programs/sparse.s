; The elements, the order vector and the two lengths of a sparse result are compared
; with results worked out by hand: sums have an element where one source has it,
; products where both have.  A wrong place, length, missing element or data flag makes a
; word or bit differ.
; tests: ADDNS ADDUS ADDLS SUBNS SUBUS SUBLS MPYSS MPYUS MPYLS DIVSS DIVUS
; warns: recurrence ADDNS
; warns: zero-length ADDNS ADDUS ADDLS SUBNS SUBUS SUBLS MPYSS MPYUS MPYLS DIVSS DIVUS

        .include "sparse.inc"

; ADDNS: C := normalised(A + B) where A or B has an element
        where_one ADDNS, 11.0, -2.0, -3.0, 9.0, -0.25
        fewer ADDNS, 11.0, -2.0, -3.0, 4.5, 4.5, -0.25, 9.0, 3.0
; The result starts one word after A, so stored elements are read.  Z overwrites X.
        .data
ADDNS.chain:  .word   1.0, -2.0, 4.5, 9.0, 9.0, 9.0
        .bitvector chain_order, 6, "110100"
packed: .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .bitvector all, 6, "111111"
        .bitvector third, 6, "100100"
        .space  1
        .code
        sparse_operands
        descriptor va, ADDNS.chain, 3
        descriptor vx, chain_order, 6
        EX      to, ADDNS.chain + 64
        ADDNS   [va, vx], [vb, vy], [to], [vx]
; expect: [ADDNS.chain] = 1.0, 11.0, 11.0, -3.0, 15.5, -0.25
; expect-bits: [chain_order] = 11110100
; Every third sum of neighbours is kept.  The sums overwrite their order vector.
        sparse_operands
        descriptor va, packed, 6
        descriptor vx, all, 6
        descriptor vb, packed + 64, 5
        descriptor vy, all, 5
        descriptor vz, third, 6
        EX      to, third
        ADDNS   |[va, vx]|, |[vb, vy]|, [to] ? [vz]
; expect: [third] = 3.0, 9.0
        flags_are ADDNS, X'0000 0000 0010 0000'
; ADDUS: C := upper(A + B) where A or B has an element
        where_one ADDUS, 11.0, -2.0, -3.0, 9.0, -0.25
        fewer ADDUS, 11.0, -2.0, -3.0, 4.5, 4.5, -0.25, 9.0, 3.0
        flags_are ADDUS, X'0000 0000 0010 0000'
; ADDLS: C := lower(A + B) where A or B has an element
        where_one ADDLS, zero.90, zero.93, zero.92, zero.90, zero.96
        fewer ADDLS, zero.90, zero.93, zero.92, zero.91, zero.91, zero.96, zero.90, zero.92
        flags_are ADDLS, X'0000 0000 0010 0000'
; SUBNS: C := normalised(A - B) where A or B has an element
        where_one SUBNS, -9.0, -2.0, 3.0, 0.0, 0.25
        fewer SUBNS, -9.0, -2.0, 3.0, 4.5, -4.5, 0.25, -11.0, -3.0
        flags_are SUBNS, X'0000 0000 0010 0000'
; SUBUS: C := upper(A - B) where A or B has an element
        where_one SUBUS, -9.0, -2.0, 3.0, zero.44, 0.25
        fewer SUBUS, -9.0, -2.0, 3.0, 4.5, -4.5, 0.25, -11.0, -3.0
        flags_are SUBUS, X'0000 0000 0010 0000'
; SUBLS: C := lower(A - B) where A or B has an element
        where_one SUBLS, zero.90, zero.93, zero.92, zero.91, zero.95
        fewer SUBLS, zero.90, zero.93, zero.92, zero.91, zero.91, zero.95, zero.90, zero.92
        flags_are SUBLS, X'0000 0000 0010 0000'
; MPYSS: C := significant(A x B) where A and B have elements
        where_both MPYSS
; expect: [MPYSS.plain] = 10.0, 20.25, 9.0
; expect: [MPYSS.given] = 10.0, 0.0, 0.0, 0.0, 9.0, 9.0
; expect: [MPYSS.given_few] = -10.0, 0.0, 9.0
; expect: [MPYSS.short_order] = 10.0, 9.0
; expect: [MPYSS.short_packed] = 10.0, 4.5, 9.0
; The result overlaps A from its second element on.
        .data
MPYSS.chain:  .word   1.0, -2.0, 4.5, 9.0
        .code
        sparse_operands
        descriptor va, MPYSS.chain, 3
        EX      to, MPYSS.chain + 64
        EX      order, MPYSS.plain_order
        MPYSS   [va, vx], [vb, vy], [to], [order]
; expect: [MPYSS.chain] = 1.0, 10.0, 20.25, 9.0
        flags_are MPYSS, X'0000 0000 0010 0000'
; MPYUS: C := upper(A x B) where A and B have elements
        where_both MPYUS
; expect: [MPYUS.plain] = X'FFD6 2800 0000 0000', X'FFD7 2880 0000 0000', 9.0
; expect: [MPYUS.given] = X'FFD6 2800 0000 0000', 0.0, 0.0, 0.0, 9.0, 9.0
; expect: [MPYUS.given_few] = -10.0, 0.0, 9.0
; expect: [MPYUS.short_order] = X'FFD6 2800 0000 0000', 9.0
; expect: [MPYUS.short_packed] = X'FFD6 2800 0000 0000', X'FFD5 2400 0000 0000', 9.0
        flags_are MPYUS, X'0000 0000 0010 0000'
; MPYLS: C := lower(A x B) where A and B have elements
        where_both MPYLS
; expect: [MPYLS.plain] = zero.89, zero.88, 9.0
; expect: [MPYLS.given] = zero.89, 0.0, 0.0, 0.0, 9.0, 9.0
; expect: [MPYLS.given_few] = zero.90, 0.0, 9.0
; expect: [MPYLS.short_order] = zero.89, 9.0
; expect: [MPYLS.short_packed] = zero.89, zero.90, 9.0
        flags_are MPYLS, X'0000 0000 0010 0000'
; DIVSS: C := significant(A / B) where A and B have elements
        where_both DIVSS
; expect: [DIVSS.plain] = X'FFCE 6666 6666 6666', 1.0, 9.0
; expect: [DIVSS.given] = X'FFCE 6666 6666 6666', indefinite, indefinite, indefinite
; expect: [DIVSS.given + 4*64] = 9.0, 9.0
; expect: [DIVSS.given_few] = X'FFCE 9999 9999 999A', 0.0, 9.0
; expect: [DIVSS.short_order] = X'FFCE 6666 6666 6666', 9.0
; expect: [DIVSS.short_packed] = X'FFCE 6666 6666 6666', X'FFCF 71C7 1C71 C71C', 9.0
        flags_are DIVSS, X'0000 0000 0052 0000'
; DIVUS: C := upper(A / B) where A and B have elements
        where_both DIVUS
; expect: [DIVUS.plain] = X'FFCE 6666 6666 6666', 1.0, 9.0
; expect: [DIVUS.given] = X'FFCE 6666 6666 6666', indefinite, indefinite, indefinite
; expect: [DIVUS.given + 4*64] = 9.0, 9.0
; expect: [DIVUS.given_few] = X'FFCE 9999 9999 999A', 0.0, 9.0
; expect: [DIVUS.short_order] = X'FFCE 6666 6666 6666', 9.0
; expect: [DIVUS.short_packed] = X'FFCE 6666 6666 6666', X'FFCF 71C7 1C71 C71C', 9.0
; For operands that are not normalised, U yields more digits than S.
        .data
seven:  .word   X'0000 0000 0000 0007'
three:  .word   X'0000 0000 0000 0003'
        .bitvector present, 1, "1"
        .code
        descriptor va, seven, 1
        descriptor vb, three, 1
        descriptor vx, present, 1
        descriptor vy, present, 1
        into_sparse DIVUS.unnormalised
        DIVUS   [va, vx], [vb, vy], [to], [order]
; expect: [DIVUS.unnormalised] = X'FFD3 4AAA AAAA AAAA', 9.0
        flags_are DIVUS, X'0000 0000 0052 0000'
        EXIT
; expect-warning: zero-length
; expect-warning: recurrence
