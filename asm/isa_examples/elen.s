        EX      r10, 0x800000
        ELEN    r10, 4
        EXIT
; expect: r10 = X'0004 0000 0080 0000'
