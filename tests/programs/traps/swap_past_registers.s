; There are 256 registers: six from r251 on are too many.  Nothing is saved.
        .data
saved:  .word   9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        .code
        EX      r10, saved
        ELEN    r10, 0
        EX      r11, saved
        ELEN    r11, 6
        SWAP    [r10], r251, [r11]
; expect-trap: bad-descriptor
; expect: [saved] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
