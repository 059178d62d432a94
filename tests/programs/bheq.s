; BHEQ: if R = S go to T

        .include "half_branch.inc"

        compare less, BHEQ, 1.0, 2.0
; expect: [less] = 0

        compare equal, BHEQ, 2.0, 2.0
; expect: [equal] = 1

        compare greater, BHEQ, -1.0, -2.0
; expect: [greater] = 0

        compare unnormalised, BHEQ, 2, 2.0
; expect: [unnormalised] = 1

        compare zeros, BHEQ, 0.0, X'1000 0000'
; expect: [zeros] = 1

        compare negative, BHEQ, 0.0, -1
; expect: [negative] = 0

        compare neither, BHEQ, X'7000 0000', X'7000 0000'
; expect: [neither] = 0

        compare one_indefinite, BHEQ, 1.0, X'7000 0000'
; expect: [one_indefinite] = 0

; h0 is machine zero
        ES      taken, 1
        fetch   right, 0
        EX      target, zero
        BHEQ    h0, right, [target]
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 1

        EXIT
