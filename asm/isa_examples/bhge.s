        EXH     h20, 6
        EXH     h21, 5
        EX      r12, there
        BHGE    h20, h21, [r12]
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r13 = X'0'
