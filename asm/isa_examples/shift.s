        .include "core.s"
        load_constant r10, X'8000 0000 0000 0000'
        ES      r11, -12                ; to the right
        SHIFT   r10, r11, r12
        EXIT
; expect: r12 = X'FFF8 0000 0000 0000'
