; What follows an immediate of 24 bits is zeros.
        ES      r10, 1
        .half   X'CD14 0000', X'0500 0001'
        ES      r10, 2
; expect-trap: undefined-instruction
; expect: r10 = 1
