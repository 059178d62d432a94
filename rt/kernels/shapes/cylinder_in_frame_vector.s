; cylinder_in_frame_vector.s - intersects a queue of rays with a cylinder in the
; cylinder's own frame, its ends as planes.
;
; This is one of the formulations that were tried for Table 1 (docs/table1.md).
; Frame and record are those of cylinder_vector.s.  Across the axis:
;
;   a = du^2 + dv^2,  b = ou du + ov dv,  c = ou^2 + ov^2 - r^2
;   t = (-b - sqrt(b^2 - a c)) / a,  (-b + sqrt(b^2 - a c)) / a
;                                  valid if |ow + t dw| <= half
;   t = (-half - ow) / dw,  (half - ow) / dw
;                                  valid if (ou + t du)^2 + (ov + t dv)^2 <= r^2
;
; tin is the smallest valid t, tout the largest.  If a < tiny^2 the sides are
; skipped; if |dw| < tiny the ends are.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: textbook.

; Merges t into tin, tout in the lanes of bits1.
        .macro  candidate t
        CMPLTV  [\t], [tin], [bits2]
        ANDB    [bits2], [bits1], [bits2]
        VTOV    [\t], [tin] ? [bits2]
        CMPLTV  [tout], [\t], [bits2]
        ANDB    [bits2], [bits1], [bits2]
        VTOV    [\t], [tout] ? [bits2]
        .endm

        .macro  on_side t
        DIVSV   [\t], [w9], [\t]
        MPYSV   [\t], [w6], [w10]
        ADDNV   [w10], [w5], [w10]
        CMPGEV  sh13, |[w10]|, [bits1]
        ANDB    [bits1], [bits0], [bits1]
        candidate \t
        .endm

        .macro  on_end at
        SUBNV   \at, [w5], [w2]
        DIVSV   [w2], [w9], [w2]
        MPYSV   [w2], [w0], [w3]
        ADDNV   [w3], [w7], [w3]
        MPYSV   [w2], [w1], [w4]
        ADDNV   [w4], [w8], [w4]
        MPYSV   [w3], [w3], [w3]
        MPYSV   [w4], [w4], [w4]
        ADDNV   [w4], [w3], [w3]
        CMPGEV  sh12, [w3], [bits1]
        ANDB    [bits1], [bits0], [bits1]
        candidate w2
        .endm

; bits2 = the rays parallel to the axis.
        .macro  along_axis
        MPYS    tiny, tiny, s0
        CMPLTV  [w2], s0, [bits2]
        .endm

        .kernel cylinder
cylinder:
        load_record P_SHAPE, 14, sh0
        into_frame
        MPYSV   [w0], [w0], [w2]
        MPYSV   [w1], [w1], [w9]
        ADDNV   [w9], [w2], [w2]                ; a
        MPYSV   [w7], [w0], [w3]
        MPYSV   [w8], [w1], [w9]
        ADDNV   [w9], [w3], [w3]                ; b
        MPYSV   [w7], [w7], [w4]
        MPYSV   [w8], [w8], [w9]
        ADDNV   [w9], [w4], [w4]
        SUBNV   [w4], sh12, [w4]                ; c
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        along_axis
        MASKV   one, [w2], [w9] ? [bits2]
        MPYSV   [w3], [w3], [w10]
        MPYSV   [w2], [w4], [w11]
        SUBNV   [w10], [w11], [w4]
        CMPGEV  [w4], r0, [bits0]
        ANDNB   [bits0], [bits2], [bits0]
        SQRTV   [w4], [w4] ? [bits0]
        SUBNV   -[w3], [w4], [w11]
        on_side w11
        ADDNV   -[w3], [w4], [w11]
        on_side w11
        along_axis
        ORB     [bits0], [bits2], [bits0]
        CMPLTV  |[w6]|, tiny, [bits2]
        ANDNB   [bits0], [bits2], [bits0]
        MASKV   one, [w6], [w9] ? [bits2]
        SUBN    r0, sh13, s1
        on_end  s1
        on_end  sh13
        BIM     0, link_kernel
        .endkernel
