        ES      r10, -1
        ES      r11, 5
        EX      r12, there
        BLT     r10, r11, [r12]
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r13 = X'0'
