; CNTOB: T := number of ones in R

        .include "vector.inc"

        .data
        .bitvector some, 12, "000001101111"
long:   .word   X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF'
        .word   X'0000 0000 0000 0003'
        .code

        descriptor from, some, 12
        CNTOB   [from], r40
        IX      from, 6                 ; a string begins at any bit
        ELEN    from, 4
        CNTOB   [from], r41
        descriptor from, long, 192
        CNTOB   [from], r42
        ELEN    from, 191
        CNTOB   [from], r43
        IX      from, 60
        ELEN    from, 70
        CNTOB   [from], r44
        ES      r45, 5
        ELEN    from, 0
        CNTOB   [from], r45
; expect: r40 = 6
; expect: r41 = 3
; expect: r42 = 130
; expect: r43 = 129
; expect: r44 = 68
; expect: r45 = 0

        EXIT
; expect-warning: zero-length
