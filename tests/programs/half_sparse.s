; Sparse results of half words are compared with elements, bits and lengths worked out
; by hand. A wrong place, length or size of an element makes one differ.
; Sparse vectors of half words.  The order vectors are
;
;       110100 of A     101101 of B
;
; so the elements of a sum are: a sum, A alone, B alone, a sum, B alone.  A product
; has two elements.
        .include "half_vector.inc"

        .regs   r42, vx, vy
        .regs   r50, elements, places

        .macro  uses op, length
        into    \op\().plain
        .data
\op\().order: .word X'FFFF FFFF FFFF FFFF'
        .code
        EX      vz, \op\().order
        \op,H   [va, vx], [vb, vy], [to], [vz]
        LTOR    to, elements
        LTOR    vz, places
        EX      to, \length
        SUBX    elements, to, elements  ; 0 if the lengths are equal
        .data
\op\().lengths: .word 9.0, 9.0
        .code
        EX      place, \op\().lengths
        STO     [place], elements
        STO     [place, once], places
        .endm

        odd
a:      .halfword 1.0, -2.0, 4.5
        odd
b:      .halfword 10.0, -3.0, 4.5, -0.25
        .bitvector in_a, 6, "110100"
        .bitvector in_b, 6, "101101"
        .code
        descriptor va, a, 3
        descriptor vb, b, 4
        descriptor vx, in_a, 6
        descriptor vy, in_b, 6
        ES      once, 1
        ES      by, 1
        uses    ADDNS, 5
; expect-halves: [ADDNS.plain] = 11.0, -2.0, -3.0, 9.0, -0.25
; expect-bits: [ADDNS.order] = 111101 11
; expect: [ADDNS.lengths] = 0, 6
        uses    ADDUS, 5
; expect-halves: [ADDUS.plain] = 11.0, -2.0, -3.0, 9.0, -0.25
        uses    ADDLS, 5
; expect-halves: [ADDLS.plain] = X'D600 0000', X'D300 0000', X'D400 0000', X'D600 0000'
; expect-halves: [ADDLS.plain + 4*32] = X'D000 0000'
        uses    SUBNS, 5
; expect-halves: [SUBNS.plain] = -9.0, -2.0, 3.0, 0.0, 0.25
        uses    SUBUS, 5
; expect-halves: [SUBUS.plain] = -9.0, -2.0, 3.0, X'EC00 0000', 0.25
; expect-bits: [SUBUS.order] = 111101 11
; expect: [SUBUS.lengths] = 0, 6
        uses    SUBLS, 5
; expect-halves: [SUBLS.plain] = X'D600 0000', X'D300 0000', X'D400 0000', X'D500 0000'
; expect-halves: [SUBLS.plain + 4*32] = X'D100 0000'
        uses    MPYSS, 2
; expect-halves: [MPYSS.plain] = 10.0, 20.25, kept, kept, kept
; expect-bits: [MPYSS.order] = 100100 11
; expect: [MPYSS.lengths] = 0, 6
        uses    MPYUS, 2
; expect-halves: [MPYUS.plain] = X'EE28 0000', X'EF28 8000', kept
        uses    MPYLS, 2
; expect-halves: [MPYLS.plain] = X'D700 0000', X'D800 0000', kept
        uses    DIVSS, 2
; expect-halves: [DIVSS.plain] = 0.1, 1.0, kept
        uses    DIVUS, 2
; expect-halves: [DIVUS.plain] = 0.1, 1.0, kept
; expect-bits: [DIVUS.order] = 100100 11
; expect: [DIVUS.lengths] = 0, 6
; The order vector of the result is given; its third place has an element of B alone.
        into    given
        .data
        .bitvector wanted, 4, "1011"
        .code
        descriptor vz, wanted, 4
        SUBNS,H |[va, vx]|, |[vb, vy]|, [to] ? [vz]
        LTOR    vz, places
; expect-halves: [given] = -9.0, -3.0, 0.0, kept, kept
; expect-bits: [wanted] = 1011
; expect: places = 4
; The packed vector is too short, so -2.0 is followed by machine zero.
        ELEN    va, 2
        into    short
        .data
short_order: .word 0
        .code
        EX      vz, short_order
        ADDNS,H [va, vx], [vb, vy], [to], [vz]
; expect-halves: [short] = 11.0, -2.0, -3.0, 4.5, -0.25
        EXIT
; expect-flags: X'0000 0000 0010 0000'
