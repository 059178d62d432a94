; STO: word at address R + 64 S := T

        .regs   r10, base, index, word

        .data
before: .word   9.0
list:   .word   9.0, 9.0, 9.0
        .code

        EX      base, list
        EX      word, 1234
        ELEN    word, 7
        STO     [base], word
; expect: [list] = X'0007 0000 0000 04D2'

        ES      index, -1
        STO     [base, index], index
; expect: [before] = X'0000 FFFF FFFF FFFF'

; of a descriptor and of an index only the low 48 bits count
        ELEN    base, 3
        ES      index, 1
        ELEN    index, 5
        STO     [base, index], word
; expect: [list + 64] = X'0007 0000 0000 04D2'

        ES      index, 2
        STO     [base, index], r0       ; register 0 as bits is 0
; expect: [list + 2*64] = 0

        EXIT
