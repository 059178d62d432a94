        ES      r10, 5
        ES      r11, 5
        EX      r12, there
        BEQ     r10, r11, [r12]
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r13 = X'0'
