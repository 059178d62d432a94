        EXH     h20, -1
        EXH     h21, 5
        EX      r12, there
        BHLT    h20, h21, [r12]
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r13 = X'0'
