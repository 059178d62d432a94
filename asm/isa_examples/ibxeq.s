        ES      r10, 0
        ES      r11, 1
        ES      r12, 1
loop:   IS      r13, 1
        IBXEQ   r10, r11, r12, loop, r10
        EXIT
; expect: r10 = 2
; expect: r13 = 2
