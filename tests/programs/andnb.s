; ANDNB: C := A AND NOT B

        .include "string.inc"

        uses    ANDNB
; expect: [long] = X'0C0C 0000 5678 0000'
; expect: [long + 64] = X'00FF 0000 0FFF FFFF'
; expect-bits: [short] = 00001100000011001111
; expect-bits: [offset] = 1111111100001100000011001111
; expect: [source_offset] = X'0C00 FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111101100000011001111
; expect-bits: [short_sources] = 01100000000000001111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
