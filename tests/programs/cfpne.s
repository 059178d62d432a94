; CFPNE: if A is not Z go to target

        .include "branch.inc"

        compare_near less, CFPNE, 1.0, 2.0
; expect: [less] = 1

        compare_near equal, CFPNE, 2.0, 2.0
; expect: [equal] = 0

        compare_near greater, CFPNE, -1.0, -2.0
; expect: [greater] = 1

        compare_near unnormalised, CFPNE, 2, 2.0
; expect: [unnormalised] = 0

        compare_near zeros, CFPNE, 0.0, X'0010 0000 0000 0000'
; expect: [zeros] = 0

        compare_near negative, CFPNE, 0.0, -1
; expect: [negative] = 1

        compare_near neither, CFPNE, X'7000000000000000', X'7000000000000000'
; expect: [neither] = 1

        compare_near one_indefinite, CFPNE, 1.0, X'7000 0000 0000 0000'
; expect: [one_indefinite] = 1

; r0 is machine zero
        ES      taken, 1
        fetch   right, 0
        CFPNE   r0, right, zero
        ES      taken, 0
zero:   keep_taken register_zero
; expect: [register_zero] = 0

; the target as (Y) + (B)
        ES      taken, 1
        EX      target, far - 64
        ES      step, 64
        fetch   left, 1.0
        fetch   right, 2.0
        CFPNE   left, right, [target, step]
        ES      taken, 0
        ES      taken, 0
far:    keep_taken by_registers
; expect: [by_registers] = 1

        EXIT
