        .include "core.s"
        load_constant r10, 1.0
        ES      r11, -4                 ; 4 places to the right
        ADJS    r10, r11, r12
        EXIT
; expect: r12 = X'FFD6 0400 0000 0000'
