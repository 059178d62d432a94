; Strings that are combined of two are compared bit by bit with those worked out by
; hand: any length, any first bit, offsets, short sources.  A wrong bit of one
; operation, or one beside the result, makes a bit differ.
; tests: ANDB ORB XORB NANDB NORB ANDNB ORNB EQVB
; warns: zero-length ANDB ORB XORB NANDB NORB ANDNB ORNB EQVB

        .include "string.inc"

; ANDB: C := A AND B
        uses    ANDB, 0000001100000011
; expect: [ANDB.long] = X'0303 1234 0000 9ABC', X'FF00 0000 FFFF FFFF'
; expect: [ANDB.source_offset] = X'0312 FFFF FFFF FFFF'
; expect-bits: [ANDB.any_bit] = 111111110000001100001111
; expect-bits: [ANDB.short_sources] = 10000000000000001111
; ORB: C := A OR B
        uses    ORB, 0011111100111111
; expect: [ORB.long] = X'3F3F FFFF 5678 FFFF', X'FFFF FF00 FFFF FFFF'
; expect: [ORB.source_offset] = X'3FFF FFFF FFFF FFFF'
; expect-bits: [ORB.any_bit] = 111111111111001111111111
; expect-bits: [ORB.short_sources] = 11111001100000001111
; XORB: C := A XOR B
        uses    XORB, 0011110000111100
; expect: [XORB.long] = X'3C3C EDCB 5678 6543', X'00FF FF00 0FFF FFFF'
; expect: [XORB.source_offset] = X'3CED FFFF FFFF FFFF'
; expect-bits: [XORB.any_bit] = 111111101111000011111111
; expect-bits: [XORB.short_sources] = 01111001100000001111
; NANDB: C := NOT (A AND B)
        uses    NANDB, 1111110011111100
; expect: [NANDB.long] = X'FCFC EDCB FFFF 6543', X'00FF FFFF 0FFF FFFF'
; expect: [NANDB.source_offset] = X'FCED FFFF FFFF FFFF'
; expect-bits: [NANDB.any_bit] = 111111101111110011111111
; expect-bits: [NANDB.short_sources] = 01111111111111111111
; NORB: C := NOT (A OR B)
        uses    NORB, 1100000011000000
; expect: [NORB.long] = X'C0C0 0000 A987 0000', X'0000 00FF 0FFF FFFF'
; expect: [NORB.source_offset] = X'C000 FFFF FFFF FFFF'
; expect-bits: [NORB.any_bit] = 111111100000110000001111
; expect-bits: [NORB.short_sources] = 00000110011111111111
; ANDNB: C := A AND NOT B
        uses    ANDNB, 0000110000001100
; expect: [ANDNB.long] = X'0C0C 0000 5678 0000', X'00FF 0000 0FFF FFFF'
; expect: [ANDNB.source_offset] = X'0C00 FFFF FFFF FFFF'
; expect-bits: [ANDNB.any_bit] = 111111101100000011001111
; expect-bits: [ANDNB.short_sources] = 01100000000000001111
; ORNB: C := A OR NOT B
        uses    ORNB, 1100111111001111
; expect: [ORNB.long] = X'CFCF 1234 FFFF 9ABC', X'FFFF 00FF FFFF FFFF'
; expect: [ORNB.source_offset] = X'CF12 FFFF FFFF FFFF'
; expect-bits: [ORNB.any_bit] = 111111111100111111001111
; expect-bits: [ORNB.short_sources] = 11100110011111111111
; EQVB: C := NOT (A XOR B)
        uses    EQVB, 1100001111000011
; expect: [EQVB.long] = X'C3C3 1234 A987 9ABC', X'FF00 00FF FFFF FFFF'
; expect: [EQVB.source_offset] = X'C312 FFFF FFFF FFFF'
; expect-bits: [EQVB.any_bit] = 111111110000111100001111
; expect-bits: [EQVB.short_sources] = 10000110011111111111
        EXIT
; expect-flags: 0
; expect-warning: zero-length
