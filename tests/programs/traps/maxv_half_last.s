; Number 255 has no register after it for the index.
        ES      r10, 1
        .half   X'D880 000A', X'0000 00FF' ; MAXV,H [r10], h255
        ES      r10, 2
; expect-trap: undefined-instruction
; expect: r10 = 1
; expect-warning: unset-length
