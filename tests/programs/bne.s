; BNE: if R is not S go to T

        .include "branch.inc"

        compare less, BNE, 1.0, 2.0
; expect: [less] = 1

        compare equal, BNE, 2.0, 2.0
; expect: [equal] = 0

        compare greater, BNE, -1.0, -2.0
; expect: [greater] = 1

        compare unnormalised, BNE, 2, 2.0
; expect: [unnormalised] = 0

        compare zeros, BNE, 0.0, X'0010 0000 0000 0000'
; expect: [zeros] = 0

        compare negative, BNE, 0.0, -1
; expect: [negative] = 1

        compare neither, BNE, X'7000000000000000', X'7000000000000000'
; expect: [neither] = 1

        compare one_indefinite, BNE, 1.0, X'7000 0000 0000 0000'
; expect: [one_indefinite] = 1

; r0 is machine zero
        ES      taken, 1
        fetch   right, 0
        EX      target, zero
        BNE     r0, right, [target]
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 0

        EXIT
