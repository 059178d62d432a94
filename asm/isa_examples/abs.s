        .include "core.s"
        load_constant r10, -2.5
        ABS     r10, r11
        EXIT
; expect: r11 = 2.5
