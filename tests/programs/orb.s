; ORB: C := A OR B

        .include "string.inc"

        uses    ORB
; expect: [long] = X'3F3F FFFF 5678 FFFF'
; expect: [long + 64] = X'FFFF FF00 FFFF FFFF'
; expect-bits: [short] = 00111111001111111111
; expect-bits: [offset] = 1111111100111111001111111111
; expect: [source_offset] = X'3FFF FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111111111001111111111
; expect-bits: [short_sources] = 11111001100000001111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
