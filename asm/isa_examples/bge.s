        ES      r10, 6
        ES      r11, 5
        EX      r12, there
        BGE     r10, r11, [r12]
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r13 = X'0'
