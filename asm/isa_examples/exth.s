        .include "core.s"
        load_half h20, -1.5, r9
        EXTH    h20, r11
        EXIT
; expect: r11 = -1.5
