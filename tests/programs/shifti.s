; SHIFTI: T := R shifted by I8: left circular, or right (negative) with the
; sign extended

        .include "scalar.inc"

        fetch   left, X'8123 4567 89AB CDEF'
        SHIFTI  left, 4, r40
        SHIFTI  left, 0, r41
        SHIFTI  left, 63, r42
        SHIFTI  left, -4, r43
        SHIFTI  left, -63, r44
        SHIFTI  left, -64, r45
; expect: r40 = X'1234 5678 9ABC DEF8'
; expect: r41 = X'8123 4567 89AB CDEF'
; expect: r42 = X'C091 A2B3 C4D5 E6F7'
; expect: r43 = X'F812 3456 789A BCDE'
; expect: r44 = X'FFFF FFFF FFFF FFFF'
; expect: r45 = X'FFFF FFFF FFFF FFFF'

        fetch   left, X'4000 0000 0000 0000'
        SHIFTI  left, -62, r46
        SHIFTI  left, -63, r47
        SHIFTI  left, 2, left           ; the source may be the result
        SHIFTI  left, 1, r0
; expect: r46 = 1
; expect: r47 = 0
; expect: r17 = 1
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
