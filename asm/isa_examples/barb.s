        ES      r10, 5
        ES      r11, 63                 ; the rightmost bit
        EX      r12, there
        BARB    r10, r11, [r12], 10     ; branch on one; set to zero
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r10 = 4
; expect: r13 = X'0'
