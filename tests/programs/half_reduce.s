; Vectors of half words to one half word.

        .include "half_vector.inc"

        .reg    left, h120
        .reg    right, h121

        odd
a:      .halfword 1.5, -200.0, 3.0, 100.0, 100.0
        odd
b:      .halfword 2.0, 0.5, 1.0, -1.0, 0.25
        odd
scalars:
        .halfword 2.0, 0.0
        odd
large:  .halfword X'1840 0000', 1.0, X'1780 0000', 1.0
        .code

        operands

; The value goes to one half of a register, the index to the whole register
; with the next number.
        EXH     right, 7
        MAXV,H  [va], left              ; the first of equals
; expect: r60 = X'F064 0000 0000 0007'
; expect: r121 = 3
        MAXV,H  |[va]|, h122
; expect: h122 = 200.0
; expect: r123 = 1
        MAXV,H  [va, once], h125 ?! [vz] ; 3.0 alone
; expect: r62 = X'0000 0000 EB60 0000'
; expect: r126 = 1
        MINV,H  [va], h126
; expect: h126 = -200.0
; expect: r127 = 1
        MINV,H  [va], h128 ? [vz]
; expect: h128 = 1.5
; expect: r129 = 0
        MINV,H  -[va], h130
; expect: h130 = -100.0
; expect: r131 = 3

        SUMV,H  [va], h132
        SUMV,H  [va], h133 ?! [vz]
; expect: h132 = 4.5
; expect: h133 = -100.0
; In element order: the first 1.0 is lost beside 2^46, the last is not.
        descriptor from, large, 4
        SUMV,H  [from], h134
; expect: h134 = 1.0

        PRODV,H [va], h136
        PRODV,H [va], h137 ? [vz]
; expect: h136 = -9000000.0
; expect: h137 = 450.0

        DOTV,H  [va], [vb], h138
        DOTV,H  x, [vb], h139
        DOTV,H  [va], [vb], h140 ? [vz]
        ELEN    vb, 2                   ; ones follow
        DOTV,H  [va], [vb], h141
; expect: h138 = -169.0
; expect: h139 = 5.5
; expect: h140 = -94.0
; expect: h141 = 106.0

; Nothing to add, to multiply, to look at.
        ELEN    va, 0
        SUMV,H  [va], h142
        PRODV,H [va], h143
        MAXV,H  [va], h144
; expect: h142 = 0.0
; expect: h143 = 1.0
; expect: h144 = X'7000 0000'

; h0 and h1 take no result.
        ELEN    va, 5
        SUMV,H  [va], h0
        SUMV,H  [va], h1
        MAXV,H  [va], h1
; expect: r0 = 0
; expect: r2 = 3

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: zero-length
