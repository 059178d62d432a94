        .include "core.s"
        load_constant r10, 3.0
        load_constant r11, -2.0
        DIVS    r10, r11, r12
        EXIT
; expect: r12 = -1.5
