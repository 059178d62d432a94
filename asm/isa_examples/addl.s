        .include "core.s"
        load_constant r10, 1.0
        load_constant r11, X'FFA0 4000 0000 0000' ; 2 to the -50
        ADDL    r10, r11, r12
        EXIT
; expect: r12 = X'FFA3 0800 0000 0000'
