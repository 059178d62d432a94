; A sum in two half registers begins with the left one.
        ES      r10, 1
        .half   X'DC80 000A', X'000A 0015' ; DOTV,H [r10], [r10], h21
        ES      r10, 2
; expect-trap: undefined-instruction
; expect: r10 = 1
; expect-warning: unset-length
