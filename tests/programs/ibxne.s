; IBXNE: C := A + X (48 bits); if C is not Z go to target

        .include "branch.inc"

        count   less, IBXNE, 3, 1, 8
; expect: [less] = 1, 4

        count   equal, IBXNE, 7, 1, 8
; expect: [equal] = 0, 8

        count   greater, IBXNE, 9, 1, 8
; expect: [greater] = 1, 10

        count   downwards, IBXNE, 3, -5, -2
; expect: [downwards] = 0, X'0000 FFFF FFFF FFFE'

        count   negative, IBXNE, -3, 1, 2
; expect: [negative] = 1, X'0000 FFFF FFFF FFFE'

; 48 bits: the sum wraps to a negative number
        count   wrapped, IBXNE, 140737488355327, 1, 0
; expect: [wrapped] = 1, X'0000 8000 0000 0000'

; the high 16 bits of the operands do not count
        count   high_bits, IBXNE, X'1234000000000003', X'FFFF000000000001', 4
; expect: [high_bits] = 0, 4

; backwards: a loop
        ES      sum, 0
        ES      step, 1
        ES      limit, 5
        ES      taken, 0
again:  ADDX    taken, step, taken
        IBXNE   sum, step, limit, again, sum
        keep_taken loop
; expect: [loop] = 5, 5

        EXIT
