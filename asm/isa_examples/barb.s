        ES      r10, 5
        ES      r11, 63                 ; the rightmost bit
        EX      r12, there
        BARB    r10, r11, [r12], 10     ; on a one; make it zero
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r10 = 4
; expect: r13 = X'0'
