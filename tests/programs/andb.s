; ANDB: C := A AND B

        .include "string.inc"

        uses    ANDB
; expect: [long] = X'0303 1234 0000 9ABC'
; expect: [long + 64] = X'FF00 0000 FFFF FFFF'
; expect-bits: [short] = 00000011000000111111
; expect-bits: [offset] = 1111111100000011000000111111
; expect: [source_offset] = X'0312 FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111110000001100001111
; expect-bits: [short_sources] = 10000000000000001111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
