        ES      r10, 5
        ES      r11, 6
        EX      r12, there
        BNE     r10, r11, [r12]
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r13 = X'0'
