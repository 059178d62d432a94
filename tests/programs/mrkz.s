; MRKZ: T := groups of S bits, the first R of each zeros, the others ones

        .include "repeat.inc"

        uses    MRKZ
; expect-bits: [plain] = 000111110001111100011111
; expect-bits: [any_bit] = 1111100100100101111
; expect: [long] = X'7FFF FFFF 7FFF FFFF', X'7FFF FFFF 7FFF FFFF'
; expect-bits: [whole_groups] = 000000001111
; expect-bits: [none] = 111111111111
; expect-bits: [negative] = 111111111111
; expect-bits: [nothing] = 11111111

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
