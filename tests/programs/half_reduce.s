; Sums, products and extremes of half word vectors are compared with registers worked
; out by hand. A result in the wrong half, or a lost part of a sum, makes one
; differ.
; Half word vectors are reduced to one half register, or to two.
; warns: zero-length MAXV,H PRODV,H SUMV,H

        .include "half_vector.inc"

        .reg    left, h120
        .reg    right, h121
        five    a, 1.5, -200.0, 3.0, 100.0, 100.0
        five    b, 2.0, 0.5, 1.0, -1.0, 0.25
        some_scalars 2.0, 0.0
        odd
large:  .halfword X'1840 0000', 1.0, X'1780 0000', 1.0
        odd
larger: .halfword X'0840 0000', 1.0
        odd
fine:   .halfword X'EA40 0001'
        .code
        operands
; The value goes to one half of a register, the index to a whole register.
        EXH     right, 7
        MAXV,H  [va], r100, left        ; the first of equals
; expect: r60 = X'F064 0000 0000 0007'
; expect: r100 = 3
        MAXV,H  |[va]|, r101, h122
; expect: h122 = 200.0
; expect: r101 = 1
        MAXV,H  [va, once], r102, h125 ?! [vz] ; only 3.0 is selected
; expect: r62 = X'0000 0000 EB60 0000'
; expect: r102 = 1
        MINV,H  [va], r103, h126
; expect: h126 = -200.0
; expect: r103 = 1
        MINV,H  [va], r104, h128 ? [vz]
; expect: h128 = 1.5
; expect: r104 = 0
        MINV,H  -[va], r105, h130
; expect: h130 = -100.0
; expect: r105 = 3
        MAXV,H  [va], r106, h213        ; the right half of r106
; expect: r106 = X'0000 0000 F064 0000'
; Both parts of a sum are in one register.  200.0 has the exponent -15, which the sum
; keeps: the upper part 4.5 is 9 x 2^14; the lower part is 0 with the exponent -15 - 23.
        SUMV,H  [va], h132
        SUMV,H  [va], h134 ?! [vz]
; expect: r66 = X'F102 4000 DA00 0000'
; expect: h134 = -100.0 ~ 0
; expect: h135 = 0.0 ~ 0
; 1.0 is lost when it is added to 2^46 or to the zero that 2^46 - 2^46 leaves.  Added
; to 2^30 it is 2^15 in the lower part, with the exponent 8 - 23.
        descriptor from, large, 4
        SUMV,H  [from], h136
; expect: r68 = X'1800 0000 0100 0000'
        descriptor from, larger, 2
        SUMV,H  [from], h138
; expect: r69 = X'0840 0000 F100 8000'
        PRODV,H [va], h140
        PRODV,H [va], h141 ? [vz]
; expect: h140 = -9000000.0
; expect: h141 = 450.0
        DOTV,H  [va], [vb], h142
        DOTV,H  x, [vb], h144
        DOTV,H  [va], [vb], h146 ? [vz]
        ELEN    vb, 2                   ; padded with ones
        DOTV,H  [va], [vb], h148
; expect: h142 = -169.0 ~ 0
; expect: h143 = 0.0 ~ 0
; expect: h144 = 5.5 ~ 0
; expect: h146 = -94.0 ~ 0
; expect: h148 = 106.0 ~ 0
; (1 + 2^-22)^2 has the product of coefficients 2^44 + 2^23 + 1.  Its lower part
; is 1 with the exponent -44.
        descriptor from, fine, 1
        DOTV,H  [from], [from], h150
; expect: r75 = X'EB20 0001 D400 0001'
; Empty vectors: of a sum, a product and a maximum.
        ELEN    va, 0
        SUMV,H  [va], h152
        PRODV,H [va], h154
        MAXV,H  [va], r107, h155
; expect: r76 = X'8000 0000 8000 0000'
; expect: h154 = 1.0
; expect: h155 = X'7000 0000'
; expect: r107 = 0
; h0 and h1 keep their values as result registers.
        ELEN    va, 5
        ES      r1, 7
        SUMV,H  [va], h0
        MAXV,H  [va], r108, h1
; expect: r0 = 0
; expect: r1 = 7
; expect: r108 = 3
        EXIT
; expect-flags: X'0000 0000 0002 0000'
; expect-warning: zero-length
