        ES      r10, 50
        WJTIME  r10
        ADDN    r10, r0, r11
        RJTIME  r12
        EXIT
; expect: r12 = 48
