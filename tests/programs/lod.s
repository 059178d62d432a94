; LOD: T := word at address R + 64 S

        .regs   r10, base, first, third, before, mixed, index

        .data
        .word   10.0
list:   .word   11.0, 12.0, X'7ABC 0123 4567 89AB'
        .code

        EX      base, list
        LOD     [base], first
; expect: r11 = 11.0

        ES      index, 2
        LOD     [base, index], third    ; all 64 bits, whatever they are
; expect: r12 = X'7ABC 0123 4567 89AB'

        ES      index, -1
        LOD     [base, index], before
; expect: r13 = 10.0

; of a descriptor and of an index only the low 48 bits count
        ELEN    base, 3
        ES      index, 1
        ELEN    index, 5
        LOD     [base, index], mixed
; expect: r14 = 12.0

        LOD     [base], r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
