        BIM     there
        ES      r10, 1                  ; skipped
there:  EXIT
; expect: r10 = X'0'
