        .include "core.s"
        load_half h20, 3, r9
        load_half h21, 5, r9
        MPYUH   h20, h21, h22
        EXIT
; expect: h22 = X'1700 0000'
; expect-warning: integer-operand
