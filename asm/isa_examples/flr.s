        .include "core.s"
        load_constant r10, -2.5
        FLR     r10, r11
        EXIT
; expect: r11 = -3
