        .include "vectors.s"
        .regs   r16, load, save
        words   load, 1, 2, 3, 4
        words   save
        ES      r20, 9
        SWAP    [load], r20, [save]     ; r20 to r23 saved, then loaded
        EXIT
; expect: [save.words] = 9, 0, 0, 0
; expect: r20 = 1
; expect: r23 = 4
