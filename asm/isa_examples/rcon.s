        .include "core.s"
        load_constant r10, 0.3
        RCON    r10, h22
        EXIT
; expect: h22 = X'E84C CCCD'
