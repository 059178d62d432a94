; Instructions lie on half words.
        BIM     next + 16
next:   ES      r10, 1
; expect-trap: misaligned-operand
; expect: r10 = 0
