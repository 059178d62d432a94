; A half word lies on a half word boundary.
        .data
list:   .halfword 1.0, 2.0
        .code
        EX      r10, list + 16
        EXH     h22, 7
        LODH    [r10], h22
; expect-trap: misaligned-operand
; expect: h22 = 7
; expect-halves: [list] = 1.0, 2.0
