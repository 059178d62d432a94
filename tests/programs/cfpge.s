; CFPGE: if A >= Z go to target

        .include "branch.inc"

        compare_near less, CFPGE, 1.0, 2.0
; expect: [less] = 0

        compare_near equal, CFPGE, 2.0, 2.0
; expect: [equal] = 1

        compare_near greater, CFPGE, -1.0, -2.0
; expect: [greater] = 1

        compare_near unnormalised, CFPGE, 2, 2.0
; expect: [unnormalised] = 1

        compare_near zeros, CFPGE, 0.0, X'0010 0000 0000 0000'
; expect: [zeros] = 1

        compare_near negative, CFPGE, 0.0, -1
; expect: [negative] = 1

        compare_near neither, CFPGE, X'7000000000000000', X'7000000000000000'
; expect: [neither] = 0

        compare_near one_indefinite, CFPGE, 1.0, X'7000 0000 0000 0000'
; expect: [one_indefinite] = 0

; r0 is machine zero
        ES      taken, 1
        fetch   right, 0
        CFPGE   r0, right, zero
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 1

; the target as (Y) + (B)
        ES      taken, 1
        EX      target, far - 64
        ES      step, 64
        fetch   left, 1.0
        fetch   right, 2.0
        CFPGE   left, right, [target, step]
        ES      taken, 0
        ES      taken, 0
far:    keep_taken by_registers
; expect: [by_registers] = 0

        EXIT
