        .include "core.s"
        load_constant r10, 3
        load_constant r11, 5
        MPYU    r10, r11, r12
        EXIT
; expect: r12 = X'002F 0000 0000 0000'
; expect-warning: integer-operand
