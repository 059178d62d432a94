; IBXGT: C := A + X (48 bits); if C > Z go to target

        .include "branch.inc"

        count   less, IBXGT, 3, 1, 8
; expect: [less] = 0, 4

        count   equal, IBXGT, 7, 1, 8
; expect: [equal] = 0, 8

        count   greater, IBXGT, 9, 1, 8
; expect: [greater] = 1, 10

        count   downwards, IBXGT, 3, -5, -2
; expect: [downwards] = 0, X'0000 FFFF FFFF FFFE'

        count   negative, IBXGT, -3, 1, 2
; expect: [negative] = 0, X'0000 FFFF FFFF FFFE'

; 48 bits: the sum wraps to a negative number
        count   wrapped, IBXGT, 140737488355327, 1, 0
; expect: [wrapped] = 0, X'0000 8000 0000 0000'

; the high 16 bits of the operands do not count
        count   high_bits, IBXGT, X'1234000000000003', X'FFFF000000000001', 4
; expect: [high_bits] = 0, 4

; backwards: a loop
        ES      sum, 0
        ES      step, 1
        ES      limit, 5
        ES      taken, 0
        EX      right, -2
again:  ADDX    taken, step, taken
        IBXGT   limit, right, step, again, limit
        ADDX    limit, r0, sum
        keep_taken loop
; expect: [loop] = 2, 1

        EXIT
