        EX      r10, double
        ES      r11, 21
        BSAVE   r12, [r10]              ; call
        EXIT
double: ADDX    r11, r11, r11
        BIM     0, r12                  ; return
; expect: r11 = 42
