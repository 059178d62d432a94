; CFPGT: if A > Z go to target

        .include "branch.inc"

        compare_near less, CFPGT, 1.0, 2.0
; expect: [less] = 0

        compare_near equal, CFPGT, 2.0, 2.0
; expect: [equal] = 0

        compare_near greater, CFPGT, -1.0, -2.0
; expect: [greater] = 1

        compare_near unnormalised, CFPGT, 2, 2.0
; expect: [unnormalised] = 0

        compare_near zeros, CFPGT, 0.0, X'0010 0000 0000 0000'
; expect: [zeros] = 0

        compare_near negative, CFPGT, 0.0, -1
; expect: [negative] = 1

        compare_near neither, CFPGT, X'7000000000000000', X'7000000000000000'
; expect: [neither] = 0

        compare_near one_indefinite, CFPGT, 1.0, X'7000 0000 0000 0000'
; expect: [one_indefinite] = 0

; r0 is machine zero
        ES      taken, 1
        fetch   right, 0
        CFPGT   r0, right, zero
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 0

; the target as (Y) + (B)
        ES      taken, 1
        EX      target, far - 64
        ES      step, 64
        fetch   left, 1.0
        fetch   right, 2.0
        CFPGT   left, right, [target, step]
        ES      taken, 0
        ES      taken, 0
far:    keep_taken by_registers
; expect: [by_registers] = 0

        EXIT
