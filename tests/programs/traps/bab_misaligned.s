; A branch that traps alters nothing.
        .data
cell:   .word   0
        .code
        EX      r10, next + 1
        EX      r11, cell
        BAB     [r11], [r10], 7
next:   ES      r11, 5
; expect-trap: misaligned-operand
; expect: [cell] = 0
