; LODH: T := half word at address R + 32 S

        .regs   r10, base, index

        .data
        .halfword 10.0
list:   .halfword 11.0, 12.0, X'7ABC 0123'
        .code

        EX      base, list              ; on any half word
        EXH     h201, 7
        LODH    [base], h200
; expect: h200 = 11.0
; expect: h201 = 7
        ES      index, 1
        LODH    [base, index], h203
; expect: r101 = X'0000 0000 ED60 0000'
        ES      index, 2
        LODH    [base, index], h204     ; all 32 bits, whatever they are
; expect: h204 = X'7ABC 0123'
        ES      index, -1
        LODH    [base, index], h205
; expect: h205 = 10.0

; of a descriptor and of an index only the low 48 bits count
        ELEN    base, 3
        ES      index, 1
        ELEN    index, 5
        LODH    [base, index], h206
; expect: h206 = 12.0

        LODH    [base], h0
        LODH    [base], h1
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
