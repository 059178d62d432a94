        ES      r10, 5
        ES      r11, -2
        ES      r12, 0
loop:   IS      r13, 1
        IBXGE   r10, r11, r12, loop, r10
        EXIT
; expect: r10 = -1
; expect: r13 = 3
