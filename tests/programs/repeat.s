; Masks that repeat a group of bits are compared bit by bit with results worked out by
; hand: any first bit, several words, empty group, empty result.  A wrong count or
; group, or a bit outside the result, makes a bit differ.
; tests: MRKO MRKZ
; warns: zero-length MRKO MRKZ

        .include "repeat.inc"

; MRKO: T := groups of S bits; each group begins with R ones and ends with zeros
        uses    MRKO
; expect-bits: [MRKO.plain] = 111000001110000011101111
; expect-bits: [MRKO.any_bit] = 1111111011011011111
; expect: [MRKO.long] = X'8000 0000 8000 0000', X'8000 0000 8FFF FFFF'
; expect-bits: [MRKO.whole_groups] = 111111111111
; expect-bits: [MRKO.none] = 000000001111
; expect-bits: [MRKO.negative] = 000000001111
; expect-bits: [MRKO.nothing] = 11111111
; MRKZ: T := groups of S bits; each group begins with R zeros and ends with ones
        uses    MRKZ
; expect-bits: [MRKZ.plain] = 000111110001111100011111
; expect-bits: [MRKZ.any_bit] = 1111100100100101111
; expect: [MRKZ.long] = X'7FFF FFFF 7FFF FFFF', X'7FFF FFFF 7FFF FFFF'
; expect-bits: [MRKZ.whole_groups] = 000000001111
; expect-bits: [MRKZ.none] = 111111111111
; expect-bits: [MRKZ.negative] = 111111111111
; expect-bits: [MRKZ.nothing] = 11111111
        EXIT
; expect-flags: 0
; expect-warning: zero-length
