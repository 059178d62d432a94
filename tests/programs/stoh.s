; STOH: half word at address R + 32 S := T

        .regs   r10, base, index

        .data
before: .halfword 9.0
list:   .halfword 9.0, 9.0, 9.0, 9.0
        .code

        EX      base, list
        EXH     h200, 1234
        EXH     h201, -1
        STOH    [base], h200
; expect-halves: [list] = X'0000 04D2'
        ES      index, -1
        STOH    [base, index], h201     ; and no other half word
; expect-halves: [before] = X'00FF FFFF'

; of a descriptor and of an index only the low 48 bits count
        ELEN    base, 3
        ES      index, 1
        ELEN    index, 5
        STOH    [base, index], h201
; expect-halves: [list + 32] = X'00FF FFFF'

        ES      index, 2
        STOH    [base, index], h1       ; h0 and h1 as bits are 0
; expect-halves: [list + 2*32] = 0, 9.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
