        .include "core.s"
        load_constant r10, X'0123 4567 89AB CDEF'
        ES      r11, 16
        ELEN    r11, 8                  ; bits 16 to 23
        EXTB    r10, r11, r12
        EXIT
; expect: r12 = 0x45
