        .include "core.s"
        load_constant r10, 7
        load_constant r11, 2
        DIVU    r10, r11, r12
        EXIT
; expect: r12 = 3.5
