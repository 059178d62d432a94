        .include "core.s"
        load_constant r10, 2.0
        load_constant r11, 1.5
        SUBU    r10, r11, r12
        EXIT
; expect: r12 = X'FFD3 1000 0000 0000'
