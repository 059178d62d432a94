; Sums, products and extremes of vectors are compared with numbers worked out by hand,
; to the last bit of both parts of a sum: every use, empty vectors, specials,
; cancellation.  A wrong order, part of a sum, index or data flag makes a word differ.
; tests: SUMV DOTV PRODV MAXV MINV
; warns: zero-length SUMV DOTV PRODV

        .include "reduce.inc"

        .macro  total op, name, a, length
        descriptor va, \a, \length
        \op     [va], value
        keep    \op\().\name
        .endm

        .macro  product name, a, b, length
        descriptor va, DOTV.\a, \length
        descriptor vb, DOTV.\b, \length
        DOTV    [va], [vb], value
        keep    DOTV.\name
        .endm

; SUMV: C, C+1 := upper and lower part of the sum of the elements of A, in
; element order
        .data
SUMV.a: .word   1.5, -2.0, 3.0, 4.5, -0.5, 100.0
SUMV.fine: .word   1.0, X'FF96 4000 0000 0000', X'FF96 4000 0000 0000'
SUMV.large: .word   X'000E 4000 0000 0000', 1.0, X'000D 8000 0000 0000', 1.0
SUMV.larger: .word   X'0030 4000 0000 0000', 1.0, X'002F 8000 0000 0000', 1.0
SUMV.odd: .word   1.0, X'7000 0000 0000 0000', 2.0
        .code
; the upper part; the lower part is in the next word
        uses    SUMV, SUMV.a
; expect: [SUMV.plain] = 106.5, 0.0 ~ 0
; expect: [SUMV.where_ones] = 9.0, 0.0 ~ 0
; expect: [SUMV.where_zeros] = 97.5, 0.0 ~ 0
; expect: [SUMV.offset_source] = 107.0, 0.0 ~ 0
        signs   SUMV
; expect: [SUMV.negated] = -106.5, 0.0 ~ 0
; expect: [SUMV.magnitudes] = 111.5, 0.0 ~ 0
; expect: [SUMV.negative] = -111.5, 0.0 ~ 0
        empty   SUMV
; expect: [SUMV.nothing] = X'8000 0000 0000 0000', X'8000 0000 0000 0000'
; Exact bits: 1.0 is 2^46 x 2^-46 and 2^-60 is 2^46 x 2^-106.  Shifted right by 60 in
; the register of 95 bits, the latter is 2^33, all of it in the lower part, which has
; the exponent -46 - 47 = -93.
        total   SUMV, one_small, SUMV.fine, 2
; expect: [SUMV.one_small] = 1.0, X'FFA3 0002 0000 0000'
        ELEN    va, 3
        SUMV    [va], value
        keep    SUMV.two_small
; expect: [SUMV.two_small] = 1.0, X'FFA3 0004 0000 0000'
; A cancelled sum keeps its exponent: 2^60 - 2^60 has the upper part 0 x 2^14.  Each 1.0
; is in the lower part, with the exponent 14 - 47, and is not lost.  join_parts adds
; the two parts; ADDN with ADDL makes two numbers of them, which later steps use.
        total   SUMV, cancelled, SUMV.large, 4
; expect: [SUMV.cancelled] = X'000E 0000 0000 0000', X'FFDF 0004 0000 0000'
        join_parts value, index, value
        keep    SUMV.joined
; expect: [SUMV.joined] = 2.0
        ELEN    va, 2
        SUMV    [va], value
        ADDL    value, index, place
        ADDN    value, index, value
        RTOR    place, index
        keep    SUMV.both
; expect: [SUMV.both] = X'000E 4000 0000 0000', X'FFDF 0002 0000 0000'
; 1.0 added to 2^94 is beyond the register; it is also beyond it when it is added to the
; zero that cancelling 2^94 leaves.
        total   SUMV, lost, SUMV.larger, 4
; expect: [SUMV.lost] = X'0030 0000 0000 0000', X'0001 0000 0000 0000'
        total   SUMV, special, SUMV.odd, 3
; expect: [SUMV.special] = indefinite, indefinite
; If C is r0, neither part is stored.
        ES      r1, 7
        SUMV    [va], r0
        register_is SUMV, r1, 7
        flags_are SUMV, X'0000 0000 0012 0000'
; DOTV: C, C+1 := upper and lower part of the sum of the products A(i) x B(i),
; in element order
        .data
DOTV.a: .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
DOTV.b: .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
DOTV.scalars:
        .word   2.0, -4.0
DOTV.fine_a: .word   X'FFD2 4000 0000 0001', 1.0
DOTV.fine_b: .word   X'FFD2 4000 0000 0001', X'FF96 4000 0000 0000'
DOTV.odd_a: .word   2.0, X'8000 0000 0000 0000', 1.0
DOTV.odd_b: .word   3.0, 5.0, X'7000 0000 0000 0000'
        .code
; the upper part; the lower part is in the next word
        uses_of_two DOTV, DOTV.
; expect: [DOTV.plain] = -5.75, 0.0 ~ 0
; expect: [DOTV.broadcast_a] = 27.5, 0.0 ~ 0
; expect: [DOTV.broadcast_b] = -424.0, 0.0 ~ 0
; expect: [DOTV.where_ones] = 21.25, 0.0 ~ 0
; expect: [DOTV.where_zeros] = -27.0, 0.0 ~ 0
; expect: [DOTV.offset_sources] = -14.75, 0.0 ~ 0
; a short source is padded with ones
; expect: [DOTV.short_source] = 116.0, 0.0 ~ 0
; expect: [DOTV.negated] = 5.75, 0.0 ~ 0
; expect: [DOTV.magnitudes] = 66.25, 0.0 ~ 0
; expect: [DOTV.nothing] = X'8000 0000 0000 0000', X'8000 0000 0000 0000'
; Exact bits: (1 + 2^-46)^2 = 1 + 2^-45 + 2^-92.  The product of coefficients is
; 2^92 + 2^47 + 1; its upper part is 2^45 + 1 with the exponent -45, its lower part is
; 1 with the exponent -92.  1.0 x 2^-60 has the upper part 2^45 with the exponent
; -105; shifted right by 60 it is 2^32 in the lower part.
        product square, fine_a, fine_b, 1
; expect: [DOTV.square] = X'FFD3 2000 0000 0001', X'FFA4 0000 0000 0001'
        product two_products, fine_a, fine_b, 2
; expect: [DOTV.two_products] = X'FFD3 2000 0000 0001', X'FFA4 0001 0000 0001'
; The upper part is normalised; then ADDN makes one number of both parts, and ADDL
; gives the rest of that sum.
        ADDN    value, r0, value
        ADDL    value, index, place
        ADDN    value, index, value
        RTOR    place, index
        keep    DOTV.both
; expect: [DOTV.both] = X'FFD2 4000 0000 0002', X'FFA3 0002 0000 0002'
        product zero, odd_a, odd_b, 2       ; machine zero adds nothing
; expect: [DOTV.zero] = 6.0, 0.0 ~ 0
        product special, odd_a, odd_b, 3
; expect: [DOTV.special] = indefinite, indefinite
; If C is r0, neither part is stored.
        ES      r1, 7
        DOTV    [va], [vb], r0
        register_is DOTV, r1, 7
        flags_are DOTV, X'0000 0000 0012 0000'
; PRODV: C := significant product of the elements of A, in element order
        .data
PRODV.a: .word   1.5, -2.0, 3.0, 4.0, -0.5, 8.0
PRODV.odd: .word   2.0, X'6FFF 7FFF FFFF FFFF', 0.0
        .code
        uses    PRODV, PRODV.a
; expect: [PRODV.plain] = 144.0
; expect: [PRODV.where_ones] = 18.0
; expect: [PRODV.where_zeros] = 8.0
; expect: [PRODV.offset_source] = -48.0
        signs   PRODV
; expect: [PRODV.negated] = 144.0
; expect: [PRODV.magnitudes] = 144.0
; expect: [PRODV.negative] = 144.0
        ELEN    va, 0
        PRODV   [va], value
        keep    PRODV.nothing
; expect: [PRODV.nothing] = 1.0
        total   PRODV, special, PRODV.odd, 3
; expect: [PRODV.special] = indefinite
        flags_are PRODV, X'0000 0000 0022 0000'

        .macro  finds op, name, a, index, value
        \op     \a, \index, \value
        keep    \op\().\name
        .endm

; MAXV: C := greatest element of A; B := its index
        .data
MAXV.a: .word   1.0, -200.0, 3.0, 100.0, 100.0, -200.0
MAXV.odd: .word   1.0, X'7000 0000 0000 0003', 2.0
        .bitvector MAXV.zeros, 3, "000"
        .code
; the first of equal elements, with its index among all elements; the index is in the
; next word
        .macro  greatest source, result
        MAXV    \source, index, \result
        .endm
        uses    greatest, MAXV.a
; expect: [greatest.plain] = 100.0, 3
; expect: [greatest.where_ones] = 100.0, 3
; expect: [greatest.where_zeros] = 100.0, 4
; the index counts from the first element after the offset
; expect: [greatest.offset_source] = 100.0, 1
        signs   greatest
; expect: [greatest.negated] = 200.0, 1
; expect: [greatest.magnitudes] = 200.0, 1
; expect: [greatest.negative] = -1.0, 0
; Both registers are optional; if they are the same one, it receives the value.
        ES      value, 7
        finds   MAXV, index_alone, [va], value, r0
; expect: [MAXV.index_alone] = 3
        ES      index, 7
        finds   MAXV, value_alone, [va], r0, value
; expect: [MAXV.value_alone] = 100.0, 7
        finds   MAXV, one_register, [va], value, value
; expect: [MAXV.one_register] = 100.0, 7
        descriptor va, MAXV.odd, 3
        finds   MAXV, special, [va], index, value ; copied unchanged
; expect: [MAXV.special] = X'7000 0000 0000 0003', 1
        descriptor vz, MAXV.zeros, 3
        finds   MAXV, held_back, [va], index, value ? [vz] ; no element is selected
; expect: [MAXV.held_back] = indefinite, 3
        flags_are MAXV, X'0000 0000 0002 0000'

; MINV: C := least element of A; B := its index
        .macro  least source, result
        MINV    \source, index, \result
        .endm
        uses    least, MAXV.a
; expect: [least.plain] = -200.0, 1
; expect: [least.where_ones] = 1.0, 0
; expect: [least.where_zeros] = -200.0, 1
; the index counts from the first element after the offset
; expect: [least.offset_source] = -200.0, 3
        signs   least
; expect: [least.negated] = -100.0, 3
; expect: [least.magnitudes] = 1.0, 0
; expect: [least.negative] = -200.0, 1
; Both registers are optional; if they are the same one, it receives the value.
        ES      value, 7
        finds   MINV, index_alone, [va], value, r0
; expect: [MINV.index_alone] = 1
        ES      index, 7
        finds   MINV, value_alone, [va], r0, value
; expect: [MINV.value_alone] = -200.0, 7
        finds   MINV, one_register, [va], value, value
; expect: [MINV.one_register] = -200.0, 7
        flags_are MINV, X'0000 0000 0000 0000'
        EXIT
; expect-warning: zero-length
