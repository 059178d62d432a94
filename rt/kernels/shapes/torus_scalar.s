; torus_scalar.s - the scalar form of the torus.

; Branches to miss if the ray stays above or below the torus.
        .macro  leave_above miss
        MPYS    near_low, dy, e0
        MPYS    near_high, dy, e1
        SUBN    r0, sh9, e2
        ADDN    e0, t1, e0
        ADDN    e1, t1, e1
        CFPGE   sh9, e0, leave_below\@
        CFPLT   sh9, e1, \miss
leave_below\@:
        CFPGE   e0, e2, leave_not\@
        CFPLT   e1, e2, \miss
leave_not\@:
        .endm

        .macro  torus_polynomial
        SUBN    near_o2, sh5, e0                ; k
        MPYS    dy, dy, e1
        MPYS    t1, dy, e3
        MPYS    t1, t1, e4
        ADDN    e0, e0, e2
        MPYS    e1, sh2, e1
        MPYS    e3, sh7, k1
        SUBN    e4, sh6, e4
        MPYS    e0, e0, e0
        ADDN    e1, e2, k2
        MPYS    e4, sh2, e4
        ADDN    r0, r0, k3
        RTOR    one, k4
        ADDN    e4, e0, k0
        .endm
