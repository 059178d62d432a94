        ES      r10, 3
        WJTIME  r10
        ES      r11, 1
        ES      r12, 2
        LSDFR   r0, r13                 ; it has run out: bit 36
        EXIT
; expect: r13 = X'0000 0000 0800 0000'
