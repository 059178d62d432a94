        .include "core.s"
        load_half h20, 2.0, r9
        load_half h21, 1.5, r9
        SUBUH   h20, h21, h22
        EXIT
; expect: h22 = X'EB10 0000'
