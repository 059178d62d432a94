; ADDX: T := low 48 bits of R + S; high 16 bits from R

        .include "scalar.inc"

        two     plain, ADDX, 5, 7
; expect: [plain] = 12

        two     negative, ADDX, 5, -7
; expect: [negative] = X'0000 FFFF FFFF FFFE'

        two     wrapped, ADDX, X'0000 FFFF FFFF FFFF', 2
; expect: [wrapped] = 1

; a descriptor keeps its length
        two     moved, ADDX, X'0064 0000 0000 1000', X'FFFF 0000 0000 0040'
; expect: [moved] = X'0064 0000 0000 1040'

        two     no_carry, ADDX, X'0001 FFFF FFFF FFFF', 1
; expect: [no_carry] = X'0001 0000 0000 0000'

        ADDX    left, r0, result        ; register 0 is 0
        keep    moved_by_none
; expect: [moved_by_none] = X'0001 FFFF FFFF FFFF'
        ADDX    left, left, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
