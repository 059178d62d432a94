; ORNB: C := A OR NOT B

        .include "string.inc"

        uses    ORNB
; expect: [long] = X'CFCF 1234 FFFF 9ABC'
; expect: [long + 64] = X'FFFF 00FF FFFF FFFF'
; expect-bits: [short] = 11001111110011111111
; expect-bits: [offset] = 1111111111001111110011111111
; expect: [source_offset] = X'CF12 FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111111100111111001111
; expect-bits: [short_sources] = 11100110011111111111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
