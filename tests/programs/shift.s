; SHIFT: T := R shifted by S: left circular, or right (negative) with the sign
; extended

        .include "scalar.inc"

        two     left_4, SHIFT, X'8123 4567 89AB CDEF', 4
; expect: [left_4] = X'1234 5678 9ABC DEF8'

        two     none, SHIFT, X'8123 4567 89AB CDEF', 0
; expect: [none] = X'8123 4567 89AB CDEF'

        two     left_63, SHIFT, 2, 63
; expect: [left_63] = 1

        two     right_4, SHIFT, X'8123 4567 89AB CDEF', -4
; expect: [right_4] = X'F812 3456 789A BCDE'

        two     right_positive, SHIFT, X'7000 0000 0000 0000', -60
; expect: [right_positive] = 7

        two     right_64, SHIFT, X'8123 4567 89AB CDEF', -64
; expect: [right_64] = X'FFFF FFFF FFFF FFFF'

; 64 and more count as the rest of the division by 64, less than -64 as -64
        two     left_68, SHIFT, X'8123 4567 89AB CDEF', 68
; expect: [left_68] = X'1234 5678 9ABC DEF8'

        two     right_1000, SHIFT, X'7123 4567 89AB CDEF', -1000
; expect: [right_1000] = 0

        SHIFT   left, r0, result        ; register 0 is 0
        keep    by_none
; expect: [by_none] = X'7123 4567 89AB CDEF'
        SHIFT   left, right, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
