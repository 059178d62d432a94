; torus_vector.s - the vector form of the torus.

; Removes rays that stay above or below the torus: y > sh9 or y < -sh9 at both
; ends.
        .macro  leave_above miss
        MPYSV   [w5], [dy], [w8]
        ADDNV   [w8], [w1], [w8]
        MPYSV   [w6], [dy], [w9]
        ADDNV   [w9], [w1], [w9]
        SUBN    r0, sh9, s0
        CMPLTV  sh9, [w8], [bits1]
        keep_where CMPLTV, sh9, [w9], bits1, bits2
        ANDNB   [bits0], [bits1], [bits0]
        CMPLTV  [w8], s0, [bits1]
        keep_where CMPLTV, [w9], s0, bits1, bits2
        ANDNB   [bits0], [bits1], [bits0]
        if_none bits0, m, \miss
        .endm

; Computes the quartics of the lanes.
        .macro  torus_polynomial
        CPSV    [w7], [e0] ? [bits0]
        SUBNV   [e0], sh5, [e0]                 ; k
        MPYSV   [lane_dy], [lane_dy], [e1]
        ADDNV   [e0], [e0], [e2]
        LINKV
        MPYSV   [e1], sh2, [e1]
        ADDNV   [e1], [e2], [k2]
        MPYSV   [lane_oy], [lane_dy], [e1]
        MPYSV   [e1], sh7, [k1]
        MPYSV   [lane_oy], [lane_oy], [e1]
        LINKV
        SUBNV   [e1], sh6, [e1]
        MPYSV   [e1], sh2, [e1]
        MPYSV   [e0], [e0], [e2]
        ADDNV   [e1], [e2], [k0]
        VTOV    r0, [k3]
        VTOV    one, [k4]
        .endm
