        .include "vectors.s"
        .regs   r16, zeros, group, c
        ES      zeros, 1
        ES      group, 3
        bits    c, "00000000"
        MRKZ    zeros, group, [c]
        EXIT
; expect-bits: [c.bits] = 01101101
