        .include "core.s"
        load_half h20, 3.0, r9
        load_half h21, -2.0, r9
        DIVSH   h20, h21, h22
        EXIT
; expect: h22 = -1.5
