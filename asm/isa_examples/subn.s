        .include "core.s"
        load_constant r10, 2.0
        load_constant r11, 1.5
        SUBN    r10, r11, r12
        EXIT
; expect: r12 = 0.5
