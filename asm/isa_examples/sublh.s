        .include "core.s"
        load_half h20, 1.0, r9
        load_half h21, X'D040 0000', r9
        SUBLH   h20, h21, h22
        EXIT
; expect: h22 = X'D378 0000'
