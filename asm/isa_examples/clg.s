        .include "core.s"
        load_constant r10, 2.25
        CLG     r10, r11
        EXIT
; expect: r11 = 3
