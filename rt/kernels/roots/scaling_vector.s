; scaling_vector.s - scales polynomials with coefficients of any size for the
; root solver.
;
; With t = 2^k x and a common factor the coefficients become
;
;   d_i = c_i 2^(k i - s),     k = floor((e_0 - e_p) / p),  s = e_p + k p
;
; where p is the degree and e_i the exponent of c_i.  The first and the last
; coefficient get one size, d_p in [1, 2) and d_0 in [1, 16).  Only exponents
; change, so nothing is lost.  With 2^M the size of the largest, all roots are
; in
;
;   2^-(M+2) < |x| < 2^(M+2)        (Cauchy)
;
; A trailing zero is a root at 0.  All of them are removed first, by moving the
; coefficients down.  A coefficient less than 2^-20000 d_p becomes 0.  A
; polynomial is rejected if M > 6900 or if a root might exceed the machine's
; range.
;
; In:  the planes at c4 .. c0 and bound.
; Out: [d4] .. [d0], [x_low] = the bound / 2^k, [size] = 2^k, [far] = 2^(M+2),
;      [near] = 2^-(M+2); bits: at_zero (0 is a root above the bound), refused.
; Changes e0-e4, top, degree, k, t0-t2, bits0.

        .macro  move_down
        CMPEQV  [d0], r0, [bits0]
        CNTOB   [bits0], number
        IBXEQ   number, r0, r0, scaling_moved
        VTOV    [d1], [d0] ? [bits0]
        VTOV    [d2], [d1] ? [bits0]
        VTOV    [d3], [d2] ? [bits0]
        VTOV    [d4], [d3] ? [bits0]
        VTOV    r0, [d4] ? [bits0]
        .endm

        .macro  exponent_of d, e, present
        EXPV    [\d], [\e]
        ADDNV   [\e], r0, [\e]
        CMPNEV  [\d], r0, [\present]
        .endm

        .macro  find_top e, present, power
        VTOV    [\e], [top] ? [\present]
        VTOV    \power, [degree] ? [\present]
        .endm

; e := the new exponent, relative to that of d_p.
        .macro  shift_exponent e, present, power
        LINKV
        MPYSV   [k], \power, [t0]
        ADDNV   [\e], [t0], [\e]
        SUBNV   [\e], [top], [\e]
        CMPLTV  [largest], [\e], [bits0]
        ANDB    [bits0], [\present], [bits0]
        VTOV    [\e], [largest] ? [bits0]
        .endm

; Makes the word with the exponent e - 46, a number, and the coefficient of d.
        .macro  pack_exponent e, d, into
        SUBNV   [\e], forty_six, [t0]
        FLRV    [t0], [t0]
        PACKV   [t0], \d, [\into]
        .endm

        .macro  scale_coefficient d, e, present
        pack_exponent \e, [\d], \d
        CMPGEV  [\e], least_exponent, [bits0]
        ANDB    [bits0], [\present], [bits0]
        VTOV    r0, [\d] ?! [bits0]
        .endm

        .kernel quartic
scale:
        VTOV    [c4], [d4]
        VTOV    [c3], [d3]
        VTOV    [c2], [d2]
        VTOV    [c1], [d1]
        VTOV    [c0], [d0]
        CMPEQV  [d0], r0, [at_zero]
        move_down
        move_down
        move_down
        move_down
scaling_moved:
        exponent_of d0, e0, present0
        exponent_of d1, e1, present1
        exponent_of d2, e2, present2
        exponent_of d3, e3, present3
        exponent_of d4, e4, present4
        ANDB    [at_zero], [present0], [at_zero]
        CMPLTV  [bound], r0, [bits0]
        ANDB    [at_zero], [bits0], [at_zero]

        VTOV    [e0], [top]
        VTOV    one, [degree]
        find_top e1, present1, one
        find_top e2, present2, two
        find_top e3, present3, three
        find_top e4, present4, four
        SUBNV   [e0], [top], [t0]
        LINKV
        DIVSV   [t0], [degree], [t0]
        FLRV    [t0], [t0]
        ADDNV   [t0], r0, [k]
        MPYSV   [k], [degree], [t0]
        ADDNV   [top], [t0], [top]

        VTOV    r0, [largest]
        SUBNV   [e0], [top], [e0]
        CMPLTV  [largest], [e0], [bits0]
        VTOV    [e0], [largest] ? [bits0]
        shift_exponent e1, present1, one
        shift_exponent e2, present2, two
        shift_exponent e3, present3, three
        shift_exponent e4, present4, four
        CMPLTV  most_above, [largest], [refused]
        ADDNV   |[k]|, [largest], [t0]
        CMPLTV  most_exponent, [t0], [bits0]
        ORB     [refused], [bits0], [refused]
        ANDB    [refused], [present0], [refused]

        scale_coefficient d0, e0, present0
        scale_coefficient d1, e1, present1
        scale_coefficient d2, e2, present2
        scale_coefficient d3, e3, present3
        scale_coefficient d4, e4, present4

        pack_exponent k, unit, size
        ADDNV   [largest], two, [t1]
        pack_exponent t1, unit, far
        SUBNV   r0, [t1], [t1]
        pack_exponent t1, unit, near

; Scales the bound: its exponent minus k, clamped to the machine's range.
        EXPV    [bound], [t1]
        ADDNV   [t1], r0, [t1]
        SUBNV   [t1], [k], [t1]
        CMPLTV  most_exponent, [t1], [bits0]
        VTOV    most_exponent, [t1] ? [bits0]
        SUBN    r0, most_exponent, s0
        CMPLTV  [t1], s0, [bits0]
        VTOV    s0, [t1] ? [bits0]
        FLRV    [t1], [t1]
        PACKV   [t1], [bound], [x_low]
        CMPEQV  [bound], r0, [bits0]
        VTOV    r0, [x_low] ? [bits0]
        VTOV    [far], [x_low] ? [refused]
        BIM     0, link
        .endkernel
