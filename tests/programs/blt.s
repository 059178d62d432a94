; BLT: if R < S go to T

        .include "branch.inc"

        compare less, BLT, 1.0, 2.0
; expect: [less] = 1

        compare equal, BLT, 2.0, 2.0
; expect: [equal] = 0

        compare greater, BLT, -1.0, -2.0
; expect: [greater] = 0

        compare unnormalised, BLT, 2, 2.0
; expect: [unnormalised] = 0

        compare zeros, BLT, 0.0, X'0010 0000 0000 0000'
; expect: [zeros] = 0

        compare negative, BLT, 0.0, -1
; expect: [negative] = 0

        compare neither, BLT, X'7000000000000000', X'7000000000000000'
; expect: [neither] = 0

        compare one_indefinite, BLT, 1.0, X'7000 0000 0000 0000'
; expect: [one_indefinite] = 0

; r0 is machine zero
        ES      taken, 1
        fetch   right, 0
        EX      target, zero
        BLT     r0, right, [target]
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 0

        EXIT
