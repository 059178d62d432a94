; EQVB: C := NOT (A XOR B)

        .include "string.inc"

        uses    EQVB
; expect: [long] = X'C3C3 1234 A987 9ABC'
; expect: [long + 64] = X'FF00 00FF FFFF FFFF'
; expect-bits: [short] = 11000011110000111111
; expect-bits: [offset] = 1111111111000011110000111111
; expect: [source_offset] = X'C312 FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111110000111100001111
; expect-bits: [short_sources] = 10000110011111111111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
