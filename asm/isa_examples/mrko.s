        .include "vectors.s"
        .regs   r16, ones, group, c
        ES      ones, 1
        ES      group, 3
        bits    c, "00000000"
        MRKO    ones, group, [c]
        EXIT
; expect-bits: [c.bits] = 10010010
