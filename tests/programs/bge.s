; BGE: if R >= S go to T

        .include "branch.inc"

        compare less, BGE, 1.0, 2.0
; expect: [less] = 0

        compare equal, BGE, 2.0, 2.0
; expect: [equal] = 1

        compare greater, BGE, -1.0, -2.0
; expect: [greater] = 1

        compare unnormalised, BGE, 2, 2.0
; expect: [unnormalised] = 1

        compare zeros, BGE, 0.0, X'0010 0000 0000 0000'
; expect: [zeros] = 1

        compare negative, BGE, 0.0, -1
; expect: [negative] = 1

        compare neither, BGE, X'7000000000000000', X'7000000000000000'
; expect: [neither] = 0

        compare one_indefinite, BGE, 1.0, X'7000 0000 0000 0000'
; expect: [one_indefinite] = 0

; r0 is machine zero
        ES      taken, 1
        fetch   right, 0
        EX      target, zero
        BGE     r0, right, [target]
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 1

        EXIT
