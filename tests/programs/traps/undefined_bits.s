; An add of 32-bit operands (bit 80 of G) is not in the table.
        ES      r10, 1
        .half   X'8280 0000', X'0000 0000'
        ES      r10, 2
; expect-trap: undefined-instruction
; expect: r10 = 1
