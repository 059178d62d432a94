; Registers are saved to words.
        .data
saved:  .word   9.0, 9.0
        .code
        ES      r10, 0
        EX      r11, saved + 8
        ELEN    r11, 1
        SWAP    [r10], r20, [r11]
; expect-trap: misaligned-operand
; expect: [saved] = 9.0, 9.0
