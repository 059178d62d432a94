; A vector of numbers to be printed begins on a word.
        .data
list:   .word   1.0, 2.0
        .code
        EX      r10, list + 32
        ELEN    r10, 1
        EXIT    r10, r0, 6
; expect-trap: misaligned-operand
