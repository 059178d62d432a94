; Half word vectors that are adjusted, packed, added as integers, shifted or combined
; bit by bit are compared with half words worked out by hand.  A wrong size, shift or
; bit makes one differ.
; Vectors of half words: their parts, their bits.

        .include "half_vector.inc"

        .macro  uses op
        into    \op\().plain
        \op,H   [va], [vb], [to]
        into    \op\().broadcast
        \op,H   x, [vb], [to] ? [vz]
        .endm

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
        uses    ADJSV
; expect-halves: [ADJSV.plain] = X'FD00 0028', 1.0, X'02FF FFFC', 0.0, X'7000 0000'
; expect-halves: [ADJSV.broadcast] = X'FD000028', kept, X'02000001', X'FF00000A', kept
        uses    ADJEV
; expect-halves: [ADJEV.plain] = X'03000000', X'05000000', X'FEFFFFCC', 0.0, X'70000000'
; expect-halves: [ADJEV.broadcast] = X'03000000', kept, X'FE000014', X'01000002', kept
        uses    PACKV
; expect-halves: [PACKV.plain] = X'05000003', 5, X'F3FFFFFE', X'56000001', X'56000001'
; expect-halves: [PACKV.broadcast] = X'05000003', kept, X'05FFFFFE', X'05000001', kept
        uses    ADDXV
; expect-halves: [ADDXV.plain] = 8, X'EA400005', X'00FFFFF1', X'80123457', X'70123457'
; expect-halves: [ADDXV.broadcast] = 8, kept, 3, 6, kept
        uses    SUBXV
; expect-halves: [SUBXV.plain] = 2, X'EA3FFFFB', X'00FFFFF5', X'80123455', X'70123455'
; expect-halves: [SUBXV.broadcast] = 2, kept, 7, 4, kept
        uses    SHIFTV
; expect-halves: [SHIFTV.plain] = X'0000 0028', X'4800 001D', X'003F FFFC', X'0024 68AD'
; expect-halves: [SHIFTV.plain + 4*32] = X'E024 68AC'
; expect-halves: [SHIFTV.broadcast] = 40, kept, 1, 10, kept
; Counts of 32 and more circulate, of less than -32 are -32.
        load    x, minus
        odd
minus:  .half   X'8000 0001'
        .code
        descriptor vb, counts, n
        into    far
        SHIFTV,H x, [vb], [to]
; expect-halves: [far] = X'C0000000', X'80000001', X'FFFFFFFF', X'FFFFFFFF', X'00000003'
; Three elements, then zeros.
        descriptor va, pattern_a, 3
        descriptor vb, pattern_b, 3
        load    x, pattern_a
        uses    XORV
; expect-halves: [XORV.plain] = X'0FF0 0FF0', X'FFFF FFFF', 0, 0, 0
; expect-halves: [XORV.broadcast] = X'0FF0 0FF0', kept, X'ED34 A978', X'FF00 FF00', kept
        uses    ANDV
; expect-halves: [ANDV.plain] = X'F000 F000', 0, X'1234 5678', 0, 0
; expect-halves: [ANDV.broadcast] = X'F000 F000', kept, X'1200 5600', 0, kept
        uses    ORV
; expect-halves: [ORV.plain] = X'FFF0 FFF0', X'FFFF FFFF', X'1234 5678', 0, 0
; expect-halves: [ORV.broadcast] = X'FFF0 FFF0', kept, X'FF34 FF78', X'FF00 FF00', kept
        uses    NANDV
; expect-halves: [NANDV.plain] = X'0FFF 0FFF', X'FFFF FFFF', X'EDCB A987', X'FFFF FFFF'
; expect-halves: [NANDV.plain + 4*32] = X'FFFF FFFF'
; expect-halves: [NANDV.broadcast] = X'0FFF0FFF', kept, X'EDFFA9FF', X'FFFFFFFF', kept
        uses    NORV
; expect-halves: [NORV.plain] = X'000F000F', 0, X'EDCBA987', X'FFFFFFFF', X'FFFFFFFF'
; expect-halves: [NORV.broadcast] = X'000F 000F', kept, X'00CB 0087', X'00FF 00FF', kept
        uses    ORNV
; expect-halves: [ORNV.plain] = X'FF0FFF0F', 0, X'FFFFFFFF', X'FFFFFFFF', X'FFFFFFFF'
; expect-halves: [ORNV.broadcast] = X'FF0F FF0F', kept, X'FFCB FF87', X'FFFF FFFF', kept
        uses    ANDNV
; expect-halves: [ANDNV.plain] = X'0F00 0F00', 0, 0, 0, 0
; expect-halves: [ANDNV.broadcast] = X'0F000F00', kept, X'ED00A900', X'FF00FF00', kept
        uses    EQVV
; expect-halves: [EQVV.plain] = X'F00FF00F', 0, X'FFFFFFFF', X'FFFFFFFF', X'FFFFFFFF'
; expect-halves: [EQVV.broadcast] = X'F00F F00F', kept, X'12CB 5687', X'00FF 00FF', kept
        EXIT
; expect-flags: X'0000 0000 0012 0000'
