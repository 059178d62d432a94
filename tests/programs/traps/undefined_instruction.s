; There is no instruction of code 00.
        ES      r10, 1
        .half   0
        ES      r10, 2
; expect-trap: undefined-instruction
; expect: r10 = 1
