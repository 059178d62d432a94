; For each pair in the table a word records which branches were taken.  It is compared
; with the relation of the two operands.  A confused relation, an operand that is not
; cut to its number of bits, or a wrong target fails.
; tests: BEQ BNE BGE BLT BHEQ BHNE BHGE BHLT CFPEQ CFPNE CFPGE CFPLT CFPGT CFPLE IBXEQ
; tests: IBXNE IBXGE IBXLT IBXGT IBXLE

        .include "branch.inc"

; The operands R and S, or A and Z.
        pair    less, 1.0, 2.0
        pair    equal, 2.0, 2.0
        pair    greater, -1.0, -2.0
        pair    unnormalised, 2, 2.0
        sized_pair zeros, 0.0, X'0010 0000 0000 0000', 0.0, X'1000 0000'
        pair    negative, 0.0, -1
        words   neither, X'7000000000000000', X'7000000000000000'
        halves  neither, X'7000 0000', X'7000 0000'
        sized_pair one_indefinite, 1.0, X'7000 0000 0000 0000', 1.0, X'7000 0000'
        pair    register_zero, 0, 0
; BEQ BNE BGE BLT, BHEQ BHNE BHGE BHLT of half words: if R .. S go to T;
; CFPEQ CFPNE CFPGE CFPLT CFPGT CFPLE: if A .. Z go to target.
; The expected results of a pair:      eq ne ge lt gt le
        order   less,                    0, 1, 0, 1, 0, 1
        order   equal,                   1, 0, 1, 0, 0, 1
        order   greater,                 0, 1, 1, 0, 1, 0
        order   unnormalised,            1, 0, 1, 0, 0, 1
        order   zeros,                   1, 0, 1, 0, 0, 1
        order   negative,                0, 1, 1, 0, 1, 0
        order   neither,                 0, 1, 0, 0, 0, 0
        order   one_indefinite,          0, 1, 0, 0, 0, 0
        order   register_zero,           1, 0, 1, 0, 0, 1, r0, h0
; the target as (Y) + (B)
        by_registers CFPEQ, 0
        by_registers CFPNE, 1
        by_registers CFPGE, 0
        by_registers CFPLT, 1
        by_registers CFPGT, 0
        by_registers CFPLE, 1
; IBXEQ .. IBXLE: C := A + X (48 bits); if C .. Z go to target.
;       case, A, X, Z, sum,             eq ne ge lt gt le
        counts  less, 3, 1, 8, 4,  0, 1, 0, 1, 0, 1
        counts  equal, 7, 1, 8, 8,  1, 0, 1, 0, 0, 1
        counts  greater, 9, 1, 8, 10,  0, 1, 1, 0, 1, 0
        counts  downwards, 3, -5, -2, X'0000 FFFF FFFF FFFE',  1, 0, 1, 0, 0, 1
        counts  negative, -3, 1, 2, X'0000 FFFF FFFF FFFE',  0, 1, 0, 1, 0, 1
; the sum wraps to a negative number
        counts  wrapped, 140737488355327, 1, 0, X'0000800000000000',  0, 1, 0, 1, 0, 1
; the high 16 bits of the operands are ignored
        counts  high_bits, X'1234000000000003', X'FFFF000000000001', 4, 4,  1, 0, 1, 0, 0, 1
; a backward branch: a loop
        loop    IBXEQ, sum, limit, limit, sum, 2, 10
        loop    IBXNE, sum, step, limit, sum, 5, 5
        loop    IBXGE, limit, right, step, limit, 3, X'0000 FFFF FFFF FFFF'
        loop    IBXLT, sum, step, limit, sum, 5, 5
        loop    IBXGT, limit, right, step, limit, 2, 1
        loop    IBXLE, sum, step, limit, sum, 6, 6
        EXIT
