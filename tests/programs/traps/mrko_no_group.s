; Groups have one bit at least.
        .include "../repeat.inc"
        mask    MRKO, nothing, 1, 0, 8
; expect-trap: bad-descriptor
; expect-bits: [MRKO.nothing] = 11111111
