; BHLT: if R < S go to T

        .include "half_branch.inc"

        compare less, BHLT, 1.0, 2.0
; expect: [less] = 1

        compare equal, BHLT, 2.0, 2.0
; expect: [equal] = 0

        compare greater, BHLT, -1.0, -2.0
; expect: [greater] = 0

        compare unnormalised, BHLT, 2, 2.0
; expect: [unnormalised] = 0

        compare zeros, BHLT, 0.0, X'1000 0000'
; expect: [zeros] = 0

        compare negative, BHLT, 0.0, -1
; expect: [negative] = 0

        compare neither, BHLT, X'7000 0000', X'7000 0000'
; expect: [neither] = 0

        compare one_indefinite, BHLT, 1.0, X'7000 0000'
; expect: [one_indefinite] = 0

; h0 is machine zero
        ES      taken, 1
        fetch   right, 0
        EX      target, zero
        BHLT    h0, right, [target]
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 0

        EXIT
