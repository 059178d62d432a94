        .include "core.s"
        load_constant r10, X'0123 4567 89AB CDEF'
        SHIFTI  r10, 8, r11
        EXIT
; expect: r11 = X'2345 6789 ABCD EF01'
