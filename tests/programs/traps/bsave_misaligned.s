; A branch that traps keeps no link.
        EX      r10, next + 1
        BSAVE   r11, [r10]
next:   ES      r11, 1
; expect-trap: misaligned-operand
; expect: r11 = 0
