        .include "core.s"
        load_half h20, 2.25, r9
        SQRTH   h20, h21
        EXIT
; expect: h21 = 1.5
