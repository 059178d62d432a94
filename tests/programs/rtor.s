; RTOR: T := R

        .data
word:   .word   X'7ABC 0123 4567 89AB'
        .code

        EX      r9, word
        LOD     [r9], r10
        RTOR    r10, r11                ; all 64 bits, whatever they are
        RTOR    r10, r10
        RTOR    r10, r0
        ES      r12, 5
        RTOR    r0, r12                 ; register 0 as bits is 0
; expect: r10 = X'7ABC 0123 4567 89AB'
; expect: r11 = X'7ABC 0123 4567 89AB'
; expect: r12 = 0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
