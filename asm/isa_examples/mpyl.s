        .include "core.s"
        load_constant r10, 3
        load_constant r11, 5
        MPYL    r10, r11, r12
        EXIT
; expect: r12 = 15
