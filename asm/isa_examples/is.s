        ES      r10, 10
        IS      r10, -3
        EXIT
; expect: r10 = 7
