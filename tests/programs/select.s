; The index of the first pair with a given relation is compared with the index counted
; by hand, for every use of two vectors.  A wrong relation, an index from another
; element, or a masked pair makes a word differ.
; tests: SELEQV SELNEV SELGEV SELLTV
; warns: zero-length SELEQV SELNEV SELGEV SELLTV

        .include "reduce.inc"

; The results of the four instructions in a use.
        .macro  selected use, eq, ne, ge, lt
; expect: [SELEQV.\use] = \eq
; expect: [SELNEV.\use] = \ne
; expect: [SELGEV.\use] = \ge
; expect: [SELLTV.\use] = \lt
        .endm

; An instruction on vectors that differ in their first pair.  No match gives the length.
        .macro  selects op, set, a, b
        .data
\set\()_a: .word   \a, -2.0, 4.5, -3.0, -0.5, 100.0
\set\()_b: .word   \b, 0.5, 4.5, -5.0, -0.5, -0.25
\set\()_scalars: .word -5.0, -3.0
        .code
        uses_of_two \op, \set\()_
        flags_are \op, X'0000 0000 0000 0000'
        .endm

        selects SELEQV, seleqv, -1.0, 10.0 ; C := index of the first A = B
        selects SELNEV, selnev, 1.0, 1.0   ; C := index of the first A that is not B
        selects SELGEV, selgev, -1.0, 10.0 ; C := index of the first A >= B
        selects SELLTV, selltv, 3.0, 1.0   ; C := index of the first A < B
; The expected indices.  With an offset they count from the first element after it.
        selected plain,           2, 1, 2, 1
        selected broadcast_a,     3, 0, 3, 0
        selected broadcast_b,     3, 0, 0, 6
        selected where_ones,      2, 3, 2, 6
        selected where_zeros,     4, 1, 4, 1
        selected offset_sources,  0, 1, 0, 4
        selected short_source,    6, 1, 2, 1
        selected negated,         6, 0, 1, 0
        selected magnitudes,      2, 1, 1, 3
        selected nothing,         0, 0, 0, 0
        EXIT
; expect-warning: zero-length
