        BIM     there
        ES      r10, 1                  ; passed over
there:  EXIT
; expect: r10 = X'0'
