        ES      r10, 6
        ES      r11, -2
        ES      r12, 0
loop:   IS      r13, 1
        IBXGT   r10, r11, r12, loop, r10
        EXIT
; expect: r10 = 0
; expect: r13 = 3
