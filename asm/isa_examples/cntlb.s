        .include "vectors.s"
        .regs   r16, a, n
        bits    a, "11101011"
        CNTLB   [a], n
        EXIT
; expect: n = 3
