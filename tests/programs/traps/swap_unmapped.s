; Nothing is saved when there is nothing to load.
        .data
saved:  .word   9.0, 9.0
        .code
        ES      r10, 0
        ELEN    r10, 2
        EX      r11, saved
        ELEN    r11, 2
        ES      r20, 1
        SWAP    [r10], r20, [r11]
; expect-trap: unmapped-address
; expect: [saved] = 9.0, 9.0
; expect: r20 = 1
