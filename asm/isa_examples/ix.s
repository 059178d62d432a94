        ES      r10, 2
        IX      r10, 0x10000000000
        EXIT
; expect: r10 = 0x10000000002
