        .include "core.s"
        load_half h20, 1.0, r9
        EXPH    h20, h21
        EXIT
; expect: h21 = -22
