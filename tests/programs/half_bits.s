; Half word vectors that are adjusted, packed, added as integers, shifted or combined
; bit by bit are compared with half words worked out by hand.  A wrong size, shift or
; bit makes one differ.
; Vectors of half words: their parts, their bits.

        .include "half_vector.inc"

        odd
a:      .halfword 5, 1.0, -13, X'8012 3456', X'7012 3456'
        five    b, 3, 5, -2, 1, 1
        some_scalars 5, 0.0
        odd
pattern_a:
        .halfword X'FF00 FF00', 0, X'1234 5678'
        odd
pattern_b:
        .halfword X'F0F0 F0F0', X'FFFF FFFF', X'1234 5678'
        five    counts, 31, 32, -32, -40, 33
        .code
        operands
        both_uses ADJSV
; expect-halves: [ADJSV.plain] = X'FD00 0028', 1.0, X'02FF FFFC', 0.0, X'7000 0000'
; expect-halves: [ADJSV.broadcast] = X'FD000028', kept, X'02000001', X'FF00000A', kept
        both_uses ADJEV
; expect-halves: [ADJEV.plain] = X'03000000', X'05000000', X'FEFFFFCC', 0.0, X'70000000'
; expect-halves: [ADJEV.broadcast] = X'03000000', kept, X'FE000014', X'01000002', kept
        both_uses PACKV
; expect-halves: [PACKV.plain] = X'05000003', 5, X'F3FFFFFE', X'56000001', X'56000001'
; expect-halves: [PACKV.broadcast] = X'05000003', kept, X'05FFFFFE', X'05000001', kept
        makes   ADDXV, 8, X'EA400005', X'00FFFFF1', X'80123457', X'70123457', 8, 3, 6
        makes   SUBXV, 2, X'EA3FFFFB', X'00FFFFF5', X'80123455', X'70123455', 2, 7, 4
        makes   SHIFTV, X'00000028', X'4800001D', X'003FFFFC', X'002468AD', X'E02468AC', 40, 1, 10
; Counts of 32 and more rotate modulo 32; counts below -32 act like -32.
        load    x, minus
        odd
minus:  .half   X'8000 0001'
        .code
        descriptor vb, counts, n
        into    far
        SHIFTV,H x, [vb], [to]
; expect-halves: [far] = X'C0000000', X'80000001', X'FFFFFFFF', X'FFFFFFFF', X'00000003'
; A source of three elements, padded with zeros.
        descriptor va, pattern_a, 3
        descriptor vb, pattern_b, 3
        load    x, pattern_a
        makes   XORV, X'0FF00FF0', X'FFFFFFFF', 0, 0, 0, X'0FF00FF0', X'ED34A978', X'FF00FF00'
        makes   ANDV, X'F000 F000', 0, X'1234 5678', 0, 0, X'F000 F000', X'1200 5600', 0
        both_uses ORV
; expect-halves: [ORV.plain] = X'FFF0 FFF0', X'FFFF FFFF', X'1234 5678', 0, 0
; expect-halves: [ORV.broadcast] = X'FFF0 FFF0', kept, X'FF34 FF78', X'FF00 FF00', kept
        both_uses NANDV
; expect-halves: [NANDV.plain] = X'0FFF0FFF', X'FFFFFFFF', X'EDCBA987', X'FFFFFFFF', X'FFFFFFFF'
; expect-halves: [NANDV.broadcast] = X'0FFF0FFF', kept, X'EDFFA9FF', X'FFFFFFFF', kept
        both_uses NORV
; expect-halves: [NORV.plain] = X'000F000F', 0, X'EDCBA987', X'FFFFFFFF', X'FFFFFFFF'
; expect-halves: [NORV.broadcast] = X'000F 000F', kept, X'00CB 0087', X'00FF 00FF', kept
        both_uses ORNV
; expect-halves: [ORNV.plain] = X'FF0FFF0F', 0, X'FFFFFFFF', X'FFFFFFFF', X'FFFFFFFF'
; expect-halves: [ORNV.broadcast] = X'FF0F FF0F', kept, X'FFCB FF87', X'FFFF FFFF', kept
        makes   ANDNV, X'0F00 0F00', 0, 0, 0, 0, X'0F000F00', X'ED00A900', X'FF00FF00'
        both_uses EQVV
; expect-halves: [EQVV.plain] = X'F00FF00F', 0, X'FFFFFFFF', X'FFFFFFFF', X'FFFFFFFF'
; expect-halves: [EQVV.broadcast] = X'F00F F00F', kept, X'12CB 5687', X'00FF 00FF', kept
        EXIT
; expect-flags: X'0000 0000 0012 0000'
