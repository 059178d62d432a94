; NANDB: C := NOT (A AND B)

        .include "string.inc"

        uses    NANDB
; expect: [long] = X'FCFC EDCB FFFF 6543'
; expect: [long + 64] = X'00FF FFFF 0FFF FFFF'
; expect-bits: [short] = 11111100111111001111
; expect-bits: [offset] = 1111111111111100111111001111
; expect: [source_offset] = X'FCED FFFF FFFF FFFF'
; expect-bits: [any_bit] = 111111101111110011111111
; expect-bits: [short_sources] = 01111111111111111111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-warning: zero-length
