        ES      r10, 3
        EX      r11, loop
loop:   IS      r12, 10
        DBNZ    r10, [r11]
        EXIT
; expect: r12 = 30
; expect: r10 = 0
