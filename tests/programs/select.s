; The index of the first pair with a given relation is compared with the index counted
; by hand, for every use of two vectors.  A wrong relation, an index that is counted
; from another element, or a pair that the control vector masks makes a word
; differ.
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

; SELEQV: C := index of the first A = B, or the length
        .data
seleqv_a:
        .word   -1.0, -2.0, 4.5, -3.0, -0.5, 100.0
seleqv_b:
        .word   10.0, 0.5, 4.5, -5.0, -0.5, -0.25
seleqv_scalars:
        .word   -5.0, -3.0
        .code
        uses_of_two SELEQV, seleqv_
        flags_are SELEQV, X'0000 0000 0000 0000'
; SELNEV: C := index of the first A that is not B, or the length
        .data
selnev_a:
        .word   1.0, -2.0, 4.5, -3.0, -0.5, 100.0
selnev_b:
        .word   1.0, 0.5, 4.5, -5.0, -0.5, -0.25
selnev_scalars:
        .word   -5.0, -3.0
        .code
        uses_of_two SELNEV, selnev_
        flags_are SELNEV, X'0000 0000 0000 0000'
; SELGEV: C := index of the first A >= B, or the length
        .data
selgev_a:
        .word   -1.0, -2.0, 4.5, -3.0, -0.5, 100.0
selgev_b:
        .word   10.0, 0.5, 4.5, -5.0, -0.5, -0.25
selgev_scalars:
        .word   -5.0, -3.0
        .code
        uses_of_two SELGEV, selgev_
        flags_are SELGEV, X'0000 0000 0000 0000'
; SELLTV: C := index of the first A < B, or the length
        .data
selltv_a:
        .word   3.0, -2.0, 4.5, -3.0, -0.5, 100.0
selltv_b:
        .word   1.0, 0.5, 4.5, -5.0, -0.5, -0.25
selltv_scalars:
        .word   -5.0, -3.0
        .code
        uses_of_two SELLTV, selltv_
        flags_are SELLTV, X'0000 0000 0000 0000'
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
