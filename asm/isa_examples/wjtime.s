        ES      r10, 3
        WJTIME  r10
        ES      r11, 1
        ES      r12, 2
        LSDFR   r0, r13                 ; bit 36: it has expired
        EXIT
; expect: r13 = X'0000 0000 0800 0000'
