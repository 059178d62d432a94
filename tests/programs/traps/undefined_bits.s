; A string of bits has no 32-bit operands (bit 80 of G).
        ES      r10, 1
        .half   X'F080 0000', X'0000 0000'
        ES      r10, 2
; expect-trap: undefined-instruction
; expect: r10 = 1
; expect-warning: unset-length
