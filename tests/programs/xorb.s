; XORB: C := A XOR B

        .include "string.inc"

        uses    XORB
; expect: [long] = X'3C3C EDCB 5678 6543'
; expect: [long + 64] = X'00FF FF00 0FFF FFFF'
; expect-bits: [short] = 00111100001111001111
; expect-bits: [offset] = 1111111100111100001111001111
; expect: [source_offset] = X'3CED FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111101111000011111111
; expect-bits: [short_sources] = 01111001100000001111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
