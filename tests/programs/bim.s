; BIM: go to I48 + R

        .regs   r10, passed, offset

        BIM     first
        ES      passed, -1
first:  IS      passed, 1

        ES      offset, 64
        BIM     second - 64, offset
        ES      passed, -1
second: IS      passed, 1

; of R only the low 48 bits count; they may be negative
        EX      offset, -32
        ELEN    offset, 9
        BIM     third + 32, offset
        ES      passed, -1
third:  IS      passed, 1
; expect: r10 = 3

        EXIT
