; A sum over one broadcast number has no length.
        ES      r12, 7
        .half   X'DA10 000A', X'0000 000C' ; SUMV r10, r12
; expect-trap: bad-descriptor
; expect: r12 = 7
