; A word lies on a word boundary.
        .data
list:   .word   1.0, 2.0
        .code
        EX      r10, list + 1
        STO     [r10], r11
; expect-trap: misaligned-operand
; expect: [list] = 1.0, 2.0
; expect-warning: unwritten-register
