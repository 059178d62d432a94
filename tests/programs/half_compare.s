; Bits and indices from comparisons of half word vectors are compared with results
; counted by hand.  A wrong relation, or an index of the wrong size, makes one differ.
; Vectors of half words: compare, select, search.

        .include "half_vector.inc"

        .macro  compares op, plain, broadcast
        into_bits \op\().plain
        \op,H   [va], [vb], [to]
        into_bits \op\().broadcast
        \op,H   x, [vb], [to] ? [vz]
; expect-bits: [\op\().plain] = \plain 111
; expect-bits: [\op\().broadcast] = \broadcast 111
        .endm

        .macro  searches op
        into_words \op\().plain
        \op,H   [va], [vb], [to]
        into_words \op\().broadcast
        \op,H   x, [vb, once], [to] ? [vz]
        .endm

        odd
a:      .halfword 1.0, -2.0, 3.0, 2, X'7000 0000'
        five    b, 1.0, -3.0, 4.0, 2.0, 1.0
        some_scalars 1.0, -3.0
        .code
        operands
        compares CMPEQV, 10010, 11001
        compares CMPNEV, 01101, 01111
        compares CMPGEV, 11010, 11001
        compares CMPLTV, 00100, 01111
; An index is an integer of 64 bits in a whole register.
        SELEQV,H [va], [vb], r60
        SELEQV,H [va], [vb], r61 ?! [vz]
        SELEQV,H [va, once], y, r62     ; none of four elements
; expect: r60 = 0
; expect: r61 = 5
; expect: r62 = 4
        SELNEV,H [va], [vb], r63
        SELNEV,H x, [vb], r64 ?! [vz]
; expect: r63 = 1
; expect: r64 = 1
        SELGEV,H [va], [vb], r65
        SELGEV,H [va], [vb], r66 ?! [vz]
; expect: r65 = 0
; expect: r66 = 1
        SELLTV,H [va], [vb], r67
        SELLTV,H -|[va]|, x, r68 ?! [vz]
; expect: r67 = 2
; expect: r68 = 1
; The indices of a search are also integers of 64 bits.
        searches SCHEQV
; expect: [SCHEQV.plain] = 0, 5, 5, 3, 5
; expect: [SCHEQV.broadcast] = 3, kept, 3, 3, kept
        searches SCHNEV
; expect: [SCHNEV.plain] = 1, 0, 0, 0, 0
; expect: [SCHNEV.broadcast] = 0, kept, 0, 0, kept
        searches SCHGEV
; expect: [SCHGEV.plain] = 0, 1, 0, 0, 5
; expect: [SCHGEV.broadcast] = 0, kept, 0, 0, kept
        searches SCHLTV
; expect: [SCHLTV.plain] = 2, 0, 2, 2, 5
; expect: [SCHLTV.broadcast] = 1, kept, 1, 1, kept
        EXIT
; expect-flags: X'0000 0000 0000 0000'
