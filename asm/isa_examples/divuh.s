        .include "core.s"
        load_half h20, 7, r9
        load_half h21, 2, r9
        DIVUH   h20, h21, h22
        EXIT
; expect: h22 = 3.5
