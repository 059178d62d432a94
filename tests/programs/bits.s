; Counts of bits, and strings that are masked, merged or compressed, are compared with
; results worked out by hand: any first bit, offsets, short sources, overlaps.  A wrong
; bit, length or count makes a bit or word differ.
; tests: CNTOB CNTLB MASKB MRGB CPSB
; warns: zero-length CNTOB CNTLB MASKB MRGB

        .include "string.inc"

        .macro  makes_1 op, use, length, a, to
        into_string \op\().\use, \length
        \op     \a, \to
        .endm

        .macro  makes_2 op, use, length, a, b, to
        into_string \op\().\use, \length
        \op     \a, \b, \to
        .endm

        .data
picks:  .word   X'FF00 F0F0 0000 FFFF', X'F000 FFFF 0000 0000'
        .code
; CNTOB: T := number of ones in R
        .data
        .bitvector CNTOB.some, 12, "000001101111"
CNTOB.long: .word   X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF'
        .word   X'0000 0000 0000 0003'
        .code
        descriptor from, CNTOB.some, 12
        CNTOB   [from], r40
        IX      from, 6                 ; a string can start at any bit
        ELEN    from, 4
        CNTOB   [from], r41
        descriptor from, CNTOB.long, 192
        CNTOB   [from], r42
        ELEN    from, 191
        CNTOB   [from], r43
        IX      from, 60
        ELEN    from, 70
        CNTOB   [from], r44
        ES      r45, 5
        ELEN    from, 0
        CNTOB   [from], r45
        register_is CNTOB, r40, 6
        register_is CNTOB, r41, 3
        register_is CNTOB, r42, 130
        register_is CNTOB, r43, 129
        register_is CNTOB, r44, 68
        register_is CNTOB, r45, 0
; CNTLB: T := number of leading bits of R that are equal to the first bit
        .data
        .bitvector CNTLB.zeros_first, 12, "000001101111"
        .bitvector CNTLB.ones_first, 5, "11101"
CNTLB.long: .word   0, 0, 0
        .code
        descriptor from, CNTLB.zeros_first, 12
        CNTLB   [from], r40
        IX      from, 5                 ; a string can start at any bit
        ELEN    from, 7
        CNTLB   [from], r41
        descriptor from, CNTLB.ones_first, 5
        CNTLB   [from], r42
        ELEN    from, 2                 ; all bits are equal: the length
        CNTLB   [from], r43
        descriptor from, CNTLB.long, 150
        CNTLB   [from], r44
        ELEN    from, 1
        CNTLB   [from], r45
        ES      r46, 5
        ELEN    from, 0
        CNTLB   [from], r46
        register_is CNTLB, r40, 5
        register_is CNTLB, r41, 2
        register_is CNTLB, r42, 3
        register_is CNTLB, r43, 2
        register_is CNTLB, r44, 150
        register_is CNTLB, r45, 1
        register_is CNTLB, r46, 0

; MASKB: C := A where Z has ones, B where Z has zeros
        .macro  strings
        descriptor va, first, 100
        descriptor vb, second, 100
        EX      vz, picks               ; its length is ignored
        .endm
        strings
        ES      by, 8
        makes_2 MASKB, long, 100, [va], [vb], [to] ? [vz]
        makes_2 MASKB, where_zeros, 16, [va], [vb], [to] ?! [vz]
        makes_2 MASKB, offset, 24, [va], [vb], [to, by] ? [vz] ; also offsets the control vector
        into_string MASKB.any_bit, 13         ; a string can start at any bit
        IX      va, 5
        IX      vb, 3
        IX      vz, 4
        IX      to, 7
        MASKB   [va], [vb], [to] ? [vz]
        ELEN    va, 4                   ; padded with zeros
        ELEN    vb, 9
        makes_2 MASKB, short_sources, 16, [va], [vb], [to] ? [vz]
        makes_2 MASKB, nothing, 0, [va], [vb], [to] ? [vz]
; expect: [MASKB.long] = X'0F33 1F3F 0000 9ABC', X'FF00 0000 FFFF FFFF'
; expect-bits: [MASKB.where_zeros] = 00110011000011111111
; expect-bits: [MASKB.offset] = 1111111100110011000000111111
; expect-bits: [MASKB.any_bit] = 111111111101001100101111
; expect-bits: [MASKB.short_sources] = 11101001100000001111
; expect-bits: [MASKB.nothing] = 11111111
        strings
        makes_2 MASKB, source_offset, 16, [va, by], [vb, by], [to] ? [vz] ; A and B start at bit 8
; expect-bits: [MASKB.source_offset] = 00001111111111111111
; The result overlaps its source: each bit is computed from the bit before it.
        .data
MASKB.chain: .word   X'8000 0000 0000 0000'
        .code
        descriptor va, MASKB.chain, 8
        descriptor to, MASKB.chain + 1, 8
        MASKB   [va], [vb], [to] ? [vz]
; expect: [MASKB.chain] = X'FF80 0000 0000 0000'
        flags_are MASKB, X'0000 0000 0000 0000'
; MRGB: C := the next bit of A where Z has ones, of B where it has zeros
        .data
MRGB.halves: .word   X'0000 0000 0000 0000', X'FFFF FFFF FFFF FFFF'
MRGB.chain: .word   X'8000 0000 0000 0000'
        .code
        .macro  merged_strings
        descriptor va, first, 100
        descriptor vb, second, 100
        EX      vz, picks + 12          ; 0000 1111 0000 1111 0000 0000
        .endm
        merged_strings
        ES      by, 8
        makes_2 MRGB, plain, 16, [va], [vb], [to] ? [vz]
        makes_2 MRGB, where_zeros, 16, [va], [vb], [to] ?! [vz]
        makes_2 MRGB, offset, 24, [va], [vb], [to, by] ? [vz] ; also offsets the control vector
        makes_2 MRGB, source_offset, 16, [va, by], [vb, by], [to] ? [vz] ; A and B start at bit 8
        IX      va, 5
        IX      vb, 3
        ELEN    va, 4                   ; padded with zeros
        ELEN    vb, 6
        makes_2 MRGB, short_sources, 16, [va], [vb], [to] ? [vz]
        makes_2 MRGB, nothing, 0, [va], [vb], [to] ? [vz]
; expect-bits: [MRGB.plain] = 00110000001111111111
; expect-bits: [MRGB.where_zeros] = 00000011111100111111
; expect-bits: [MRGB.offset] = 1111111100110000001100111111
; expect-bits: [MRGB.source_offset] = 00110000001111111111
; expect-bits: [MRGB.short_sources] = 10011110100000001111
; expect-bits: [MRGB.nothing] = 11111111
        merged_strings
        EX      vz, MRGB.halves
        makes_2 MRGB, long, 100, [va], [vb], [to] ? [vz]
; expect: [MRGB.long] = X'3333 FFFF 0000 FFFF', X'0F0F 1234 5FFF FFFF'
; The result overlaps its sources: each bit is computed from the bit two before it.
        EX      vz, MRGB.halves + 64
        descriptor va, MRGB.chain, 8
        descriptor to, MRGB.chain + 2, 8
        MRGB    [va], [vb], [to] ? [vz]
; expect: [MRGB.chain] = X'AA80 0000 0000 0000'
        flags_are MRGB, X'0000 0000 0000 0000'
; CPSB: C := bits of A where Z has ones; length of C := number of ones in Z
        .data
CPSB.ones: .word   X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF'
CPSB.second_ones: .word X'5555 5555 5555 5555'
CPSB.in_place: .word X'3CFF 0000 0000 0000'
CPSB.chain: .word   X'8000 0000 0000 0000'
        .code
        descriptor va, first, 100
        descriptor vz, picks, 16        ; 8 ones, 8 zeros
        ES      by, 8
        makes_1 CPSB, plain, 1000, [va], [to] ? [vz] ; its length is ignored
        LTOR    to, r40
        makes_1 CPSB, where_zeros, 0, [va], [to] ?! [vz]
        LTOR    to, r41
        makes_1 CPSB, offset, 0, [va], [to, by] ?! [vz] ; also offsets the control vector
        LTOR    to, r42
        makes_1 CPSB, source_offset, 0, [va, by], [to] ? [vz]
        ELEN    va, 6                   ; padded with zeros
        makes_1 CPSB, short_source, 0, [va], [to] ? [vz]
        LTOR    to, r43
; expect-bits: [CPSB.plain] = 000011111111
; expect-bits: [CPSB.where_zeros] = 000011111111
; expect-bits: [CPSB.offset] = 11111111000011111111
; expect-bits: [CPSB.source_offset] = 000011111111
; expect-bits: [CPSB.short_source] = 000011001111
        register_is CPSB, r40, 8
        register_is CPSB, r41, 8
        register_is CPSB, r42, 8
        register_is CPSB, r43, 8
        descriptor va, first + 5, 95
        descriptor vz, picks + 12, 28   ; 0000 1111 0000 1111 0000 0000 0000
        into_string CPSB.any_bit, 0          ; a string can start at any bit
        IX      to, 3
        CPSB    [va], [to] ? [vz]
        descriptor va, first, 100
        descriptor vz, CPSB.ones, 100
        makes_1 CPSB, long, 0, [va], [to] ? [vz]
        LTOR    to, r44
        ELEN    vz, 0
        makes_1 CPSB, nothing, 5, [va], [to] ? [vz]
        LTOR    to, r45
        CPSB    [va], [r0] ? [vz]
; expect-bits: [CPSB.any_bit] = 111000100101111
; expect: [CPSB.long] = X'0F0F 1234 5678 9ABC', X'FFFF 0000 FFFF FFFF'
; expect-bits: [CPSB.nothing] = 11111111
        register_is CPSB, r44, 100
        register_is CPSB, r45, 0
; expect: r0 = 0
; A result may overlap its source.  Bits that it overwrites before they are read are
; read with their new values.
        descriptor vz, CPSB.second_ones, 8
        descriptor to, CPSB.in_place, 8
        CPSB    [to], [to] ? [vz]
        descriptor vz, CPSB.ones, 8
        descriptor va, CPSB.chain, 8
        descriptor to, CPSB.chain + 1, 8
        CPSB    [va], [to] ? [vz]
; expect: [CPSB.in_place] = X'6CFF 0000 0000 0000'
; expect: [CPSB.chain] = X'FF80 0000 0000 0000'
        flags_are CPSB, X'0000 0000 0000 0000'
        EXIT
; expect-warning: zero-length
