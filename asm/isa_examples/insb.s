        ES      r10, 5
        ES      r11, 56
        ELEN    r11, 4                  ; bits 56 to 59
        INSB    r10, r11, r12
        EXIT
; expect: r12 = 80
