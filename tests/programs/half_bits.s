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
        odd
b:      .halfword 3, 5, -2, 1, 1
        odd
scalars:
        .halfword 5, 0.0
        odd
pattern_a:
        .halfword X'FF00 FF00', 0, X'1234 5678'
        odd
pattern_b:
        .halfword X'F0F0 F0F0', X'FFFF FFFF', X'1234 5678'
        odd
counts: .halfword 31, 32, -32, -40, 33
        .code

        operands
        uses    ADJSV
; expect-halves: [ADJSV.plain] = X'FD00 0028', 1.0, X'02FF FFFC', 0.0
; expect-halves: [ADJSV.plain + 4*32] = X'7000 0000'
; expect-halves: [ADJSV.broadcast] = X'FD00 0028', kept, X'0200 0001'
; expect-halves: [ADJSV.broadcast + 3*32] = X'FF00 000A', kept
        uses    ADJEV
; expect-halves: [ADJEV.plain] = X'0300 0000', X'0500 0000', X'FEFF FFCC', 0.0
; expect-halves: [ADJEV.plain + 4*32] = X'7000 0000'
; expect-halves: [ADJEV.broadcast] = X'0300 0000', kept, X'FE00 0014'
; expect-halves: [ADJEV.broadcast + 3*32] = X'0100 0002', kept
        uses    PACKV
; expect-halves: [PACKV.plain] = X'0500 0003', 5, X'F3FF FFFE', X'5600 0001'
; expect-halves: [PACKV.plain + 4*32] = X'5600 0001'
; expect-halves: [PACKV.broadcast] = X'0500 0003', kept, X'05FF FFFE'
; expect-halves: [PACKV.broadcast + 3*32] = X'0500 0001', kept
        uses    ADDXV
; expect-halves: [ADDXV.plain] = 8, X'EA40 0005', X'00FF FFF1', X'8012 3457'
; expect-halves: [ADDXV.plain + 4*32] = X'7012 3457'
; expect-halves: [ADDXV.broadcast] = 8, kept, 3, 6, kept
        uses    SUBXV
; expect-halves: [SUBXV.plain] = 2, X'EA3F FFFB', X'00FF FFF5', X'8012 3455'
; expect-halves: [SUBXV.plain + 4*32] = X'7012 3455'
; expect-halves: [SUBXV.broadcast] = 2, kept, 7, 4, kept
        uses    SHIFTV
; expect-halves: [SHIFTV.plain] = X'0000 0028', X'4800 001D', X'003F FFFC'
; expect-halves: [SHIFTV.plain + 3*32] = X'0024 68AD', X'E024 68AC'
; expect-halves: [SHIFTV.broadcast] = 40, kept, 1, 10, kept

; Counts of 32 and more circulate, of less than -32 are -32.
        load    x, minus
        odd
minus:  .half   X'8000 0001'
        .code
        descriptor vb, counts, n
        into    far
        SHIFTV,H x, [vb], [to]
; expect-halves: [far] = X'C000 0000', X'8000 0001', X'FFFF FFFF', X'FFFF FFFF'
; expect-halves: [far + 4*32] = X'0000 0003'

; Three elements, then zeros.
        descriptor va, pattern_a, 3
        descriptor vb, pattern_b, 3
        load    x, pattern_a
        uses    XORV
; expect-halves: [XORV.plain] = X'0FF0 0FF0', X'FFFF FFFF', 0, 0, 0
; expect-halves: [XORV.broadcast] = X'0FF0 0FF0', kept, X'ED34 A978'
; expect-halves: [XORV.broadcast + 3*32] = X'FF00 FF00', kept
        uses    ANDV
; expect-halves: [ANDV.plain] = X'F000 F000', 0, X'1234 5678', 0, 0
; expect-halves: [ANDV.broadcast] = X'F000 F000', kept, X'1200 5600', 0, kept
        uses    ORV
; expect-halves: [ORV.plain] = X'FFF0 FFF0', X'FFFF FFFF', X'1234 5678', 0, 0
; expect-halves: [ORV.broadcast] = X'FFF0 FFF0', kept, X'FF34 FF78'
; expect-halves: [ORV.broadcast + 3*32] = X'FF00 FF00', kept
        uses    NANDV
; expect-halves: [NANDV.plain] = X'0FFF 0FFF', X'FFFF FFFF', X'EDCB A987'
; expect-halves: [NANDV.plain + 3*32] = X'FFFF FFFF', X'FFFF FFFF'
; expect-halves: [NANDV.broadcast] = X'0FFF 0FFF', kept, X'EDFF A9FF'
; expect-halves: [NANDV.broadcast + 3*32] = X'FFFF FFFF', kept
        uses    NORV
; expect-halves: [NORV.plain] = X'000F 000F', 0, X'EDCB A987'
; expect-halves: [NORV.plain + 3*32] = X'FFFF FFFF', X'FFFF FFFF'
; expect-halves: [NORV.broadcast] = X'000F 000F', kept, X'00CB 0087'
; expect-halves: [NORV.broadcast + 3*32] = X'00FF 00FF', kept
        uses    ORNV
; expect-halves: [ORNV.plain] = X'FF0F FF0F', 0, X'FFFF FFFF'
; expect-halves: [ORNV.plain + 3*32] = X'FFFF FFFF', X'FFFF FFFF'
; expect-halves: [ORNV.broadcast] = X'FF0F FF0F', kept, X'FFCB FF87'
; expect-halves: [ORNV.broadcast + 3*32] = X'FFFF FFFF', kept
        uses    ANDNV
; expect-halves: [ANDNV.plain] = X'0F00 0F00', 0, 0, 0, 0
; expect-halves: [ANDNV.broadcast] = X'0F00 0F00', kept, X'ED00 A900'
; expect-halves: [ANDNV.broadcast + 3*32] = X'FF00 FF00', kept
        uses    EQVV
; expect-halves: [EQVV.plain] = X'F00F F00F', 0, X'FFFF FFFF'
; expect-halves: [EQVV.plain + 3*32] = X'FFFF FFFF', X'FFFF FFFF'
; expect-halves: [EQVV.broadcast] = X'F00F F00F', kept, X'12CB 5687'
; expect-halves: [EQVV.broadcast + 3*32] = X'00FF 00FF', kept

        EXIT
; expect-flags: X'0000 0000 0012 0000'
