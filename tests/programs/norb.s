; NORB: C := NOT (A OR B)

        .include "string.inc"

        uses    NORB
; expect: [long] = X'C0C0 0000 A987 0000'
; expect: [long + 64] = X'0000 00FF 0FFF FFFF'
; expect-bits: [short] = 11000000110000001111
; expect-bits: [offset] = 1111111111000000110000001111
; expect: [source_offset] = X'C000 FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111100000110000001111
; expect-bits: [short_sources] = 00000110011111111111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
