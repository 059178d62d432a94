; MRKO: T := groups of S bits, the first R of each ones, the others zeros

        .include "repeat.inc"

        uses    MRKO
; expect-bits: [plain] = 111000001110000011101111
; expect-bits: [any_bit] = 1111111011011011111
; expect: [long] = X'8000 0000 8000 0000', X'8000 0000 8FFF FFFF'
; expect-bits: [whole_groups] = 111111111111
; expect-bits: [none] = 000000001111
; expect-bits: [negative] = 000000001111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
