        .include "core.s"
        load_half h20, 1.0, r9
        EXH     h21, -4                 ; 4 places to the right
        ADJSH   h20, h21, h22
        EXIT
; expect: h22 = X'EE04 0000'
