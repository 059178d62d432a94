        EXH     h20, 5
        EXH     h21, 6
        EX      r12, there
        BHNE    h20, h21, [r12]
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: r13 = X'0'
