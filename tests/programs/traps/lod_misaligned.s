; A word lies on a word boundary.
        .data
list:   .word   1.0, 2.0
        .code
        EX      r10, list + 32
        ES      r11, 7
        LOD     [r10], r11
; expect-trap: misaligned-operand
; expect: r11 = 7
