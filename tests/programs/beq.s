; BEQ: if R = S go to T

        .include "branch.inc"

        compare less, BEQ, 1.0, 2.0
; expect: [less] = 0

        compare equal, BEQ, 2.0, 2.0
; expect: [equal] = 1

        compare greater, BEQ, -1.0, -2.0
; expect: [greater] = 0

        compare unnormalised, BEQ, 2, 2.0
; expect: [unnormalised] = 1

        compare zeros, BEQ, 0.0, X'0010 0000 0000 0000'
; expect: [zeros] = 1

        compare negative, BEQ, 0.0, -1
; expect: [negative] = 0

        compare neither, BEQ, X'7000000000000000', X'7000000000000000'
; expect: [neither] = 0

        compare one_indefinite, BEQ, 1.0, X'7000 0000 0000 0000'
; expect: [one_indefinite] = 0

; r0 is machine zero
        ES      taken, 1
        fetch   right, 0
        EX      target, zero
        BEQ     r0, right, [target]
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 1

        EXIT
