        .include "core.s"
        load_constant r10, 2.5
        load_constant r11, -2.5
        CFPGT   r10, r11, there
        ES      r12, 1                  ; skipped
there:  EXIT
; expect: r12 = X'0'
