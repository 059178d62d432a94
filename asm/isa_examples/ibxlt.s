        ES      r10, 0
        ES      r11, 2
        ES      r12, 5
loop:   IS      r13, 1
        IBXLT   r10, r11, r12, loop, r10
        EXIT
; expect: r10 = 6
; expect: r13 = 3
