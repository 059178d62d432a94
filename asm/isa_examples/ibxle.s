        ES      r10, 0
        ES      r11, 2
        ES      r12, 6
loop:   IS      r13, 1
        IBXLE   r10, r11, r12, loop, r10
        EXIT
; expect: r10 = 8
; expect: r13 = 4
