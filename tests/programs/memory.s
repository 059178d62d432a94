; Words and half words are compared after loads and stores with an address and an index.
; A wrong address, a truncated index, or a changed other half makes a word differ.
; tests: LOD LODH STO STOH

        .include "keep.inc"

        .reg    index, r160
        .regs   r130, base, first, third, before, mixed, word

; Index 1.  Only the low 48 bits of a descriptor and of an index are used.
        .macro  index_1
        ELEN    base, 3
        ES      index, 1
        ELEN    index, 5
        .endm

; LOD: T := word at address R + 64 S
        .data
        .word   10.0
LOD.list: .word   11.0, 12.0, X'7ABC 0123 4567 89AB'
        .code
        EX      base, LOD.list
        LOD     [base], first
        register_is LOD, first, 11.0
        ES      index, 2
        LOD     [base, index], third    ; copies all 64 bits
        register_is LOD, third, X'7ABC 0123 4567 89AB'
        ES      index, -1
        LOD     [base, index], before
        register_is LOD, before, 10.0
        index_1
        LOD     [base, index], mixed
        register_is LOD, mixed, 12.0
        LOD     [base], r0
; expect: r0 = 0
        flags_are LOD, X'0000 0000 0000 0000'
; LODH: T := half word at address R + 32 S
        .data
        .halfword 10.0
LODH.list: .halfword 11.0, 12.0, X'7ABC 0123'
        .code
        EX      base, LODH.list              ; an address of any half word
        EXH     h201, 7
        LODH    [base], h200
        half_register_is LODH, h200, 11.0
        half_register_is LODH, h201, 7
        ES      index, 1
        LODH    [base, index], h203
        register_is LODH, r101, X'0000 0000 ED60 0000'
        ES      index, 2
        LODH    [base, index], h204     ; copies all 32 bits
        half_register_is LODH, h204, X'7ABC 0123'
        ES      index, -1
        LODH    [base, index], h205
        half_register_is LODH, h205, 10.0
        index_1
        LODH    [base, index], h206
        half_register_is LODH, h206, 12.0
        LODH    [base], h0
        LODH    [base], h1
; expect: r0 = 0
        flags_are LODH, X'0000 0000 0000 0000'
; STO: word at address R + 64 S := T
        .data
STO.before: .word   9.0
STO.list: .word   9.0, 9.0, 9.0
        .code
        EX      base, STO.list
        EX      word, 1234
        ELEN    word, 7
        STO     [base], word
; expect: [STO.list] = X'0007 0000 0000 04D2'
        ES      index, -1
        STO     [base, index], index
; expect: [STO.before] = X'0000 FFFF FFFF FFFF'
        index_1
        STO     [base, index], word
; expect: [STO.list + 1*64] = X'0007 0000 0000 04D2'
        ES      index, 2
        STO     [base, index], r0       ; as bits, register 0 is 0
; expect: [STO.list + 2*64] = 0
; STOH: half word at address R + 32 S := T
        .data
STOH.before: .halfword 9.0
STOH.list: .halfword 9.0, 9.0, 9.0, 9.0
        .code
        EX      base, STOH.list
        EXH     h200, 1234
        EXH     h201, -1
        STOH    [base], h200
; expect-halves: [STOH.list] = X'0000 04D2'
        ES      index, -1
        STOH    [base, index], h201     ; changes no other half word
; expect-halves: [STOH.before] = X'00FF FFFF'
        index_1
        STOH    [base, index], h201
; expect-halves: [STOH.list + 1*32] = X'00FF FFFF'
        ES      index, 2
        STOH    [base, index], h1       ; as bits, h0 and h1 are 0
; expect-halves: [STOH.list + 2*32] = 0, 9.0
        flags_are STOH, X'0000 0000 0000 0000'
        EXIT
