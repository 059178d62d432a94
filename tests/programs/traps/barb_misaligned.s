; A branch that traps alters nothing.
        EX      r10, next + 1
        BARB    r11, r0, [r10], 7
next:   ES      r11, 5
; expect-trap: misaligned-operand
; expect: r11 = 0
; expect-warning: unwritten-register
