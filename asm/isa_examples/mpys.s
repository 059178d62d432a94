        .include "core.s"
        load_constant r10, 1.5
        load_constant r11, -2.0
        MPYS    r10, r11, r12
        EXIT
; expect: r12 = -3.0
