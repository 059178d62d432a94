; CNTLB: T := number of leading bits of R equal to its first bit

        .include "vector.inc"

        .data
        .bitvector zeros_first, 12, "000001101111"
        .bitvector ones_first, 5, "11101"
long:   .word   0, 0, 0
        .code

        descriptor from, zeros_first, 12
        CNTLB   [from], r40
        IX      from, 5                 ; a string begins at any bit
        ELEN    from, 7
        CNTLB   [from], r41
        descriptor from, ones_first, 5
        CNTLB   [from], r42
        ELEN    from, 2                 ; all are alike: the length
        CNTLB   [from], r43
        descriptor from, long, 150
        CNTLB   [from], r44
        ELEN    from, 1
        CNTLB   [from], r45
        ES      r46, 5
        ELEN    from, 0
        CNTLB   [from], r46
; expect: r40 = 5
; expect: r41 = 2
; expect: r42 = 3
; expect: r43 = 2
; expect: r44 = 150
; expect: r45 = 1
; expect: r46 = 0

        EXIT
; expect-warning: zero-length
