; Text in page 0 cannot be printed.
        ES      r10, 64
        ELEN    r10, 3
        EXIT    r10, r0, 4
; expect-trap: unmapped-address
