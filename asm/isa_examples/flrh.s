        .include "core.s"
        load_half h20, -2.5, r9
        FLRH    h20, h21
        EXIT
; expect: h21 = -3
