; A branch that traps counts nothing.
        ES      r10, 1
        EX      r11, next + 1
        ES      r12, 10
        IBXLT   r10, r10, r12, [r11], r10
next:   ES      r10, 5
; expect-trap: misaligned-operand
; expect: r10 = 1
