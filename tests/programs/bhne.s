; BHNE: if R is not S go to T

        .include "half_branch.inc"

        compare less, BHNE, 1.0, 2.0
; expect: [less] = 1

        compare equal, BHNE, 2.0, 2.0
; expect: [equal] = 0

        compare greater, BHNE, -1.0, -2.0
; expect: [greater] = 1

        compare unnormalised, BHNE, 2, 2.0
; expect: [unnormalised] = 0

        compare zeros, BHNE, 0.0, X'1000 0000'
; expect: [zeros] = 0

        compare negative, BHNE, 0.0, -1
; expect: [negative] = 1

        compare neither, BHNE, X'7000 0000', X'7000 0000'
; expect: [neither] = 1

        compare one_indefinite, BHNE, 1.0, X'7000 0000'
; expect: [one_indefinite] = 1

; h0 is machine zero
        ES      taken, 1
        fetch   right, 0
        EX      target, zero
        BHNE    h0, right, [target]
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 0

        EXIT
