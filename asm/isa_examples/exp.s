        .include "core.s"
        load_constant r10, 1.0
        EXP     r10, r11
        EXIT
; expect: r11 = -46
