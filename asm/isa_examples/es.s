        ES      r10, -2
        EXIT
; expect: r10 = -2
