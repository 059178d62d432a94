        .include "vectors.s"
        .regs   r16, load, save
        words   load, 1, 2, 3, 4
        words   save
        ES      r20, 9
        SWAP    [load], r20, [save]     ; saves, then loads r20-r23
        EXIT
; expect: [save.words] = 9, 0, 0, 0
; expect: r20 = 1
; expect: r23 = 4
