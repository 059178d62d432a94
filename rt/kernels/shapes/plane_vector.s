; plane_vector.s - intersects a queue of rays with a half space: all X with
; N . X <= d.
;
;   t = (d - N . O) / (N . D)
;
; N . D < 0: the ray enters at t, and the segment is (t, big); else it is
; (minus_big, t).  |N . D| < tiny: the ray is parallel, inside everywhere or
; nowhere.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: textbook; the plane as the half space below its normal is POV-Ray's.

; Computes [w0] = d - N . O, [w1] = N . D, or one for the parallel rays (bits0),
; and [w2] = t, for the plane in sh0-sh3.
        .macro  intersect_plane
        dot_constant ox, oy, oz, sh0, sh1, sh2, w0, w2
        SUBNV   sh3, [w0], [w0]
        dot_constant dx, dy, dz, sh0, sh1, sh2, w1, w2
        CMPLTV  |[w1]|, tiny, [bits0]
        MASKV   one, [w1], [w1] ? [bits0]
        DIVSV   [w0], [w1], [w2]
        .endm

        .kernel plane
plane:
        load_record P_SHAPE, 4, sh0
        intersect_plane
        CMPLTV  [w1], r0, [bits1]
        MASKV   [w2], minus_big, [tin] ? [bits1]
        MASKV   big, [w2], [tout] ? [bits1]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, plane_crossed
        CMPGEV  [w0], r0, [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [tin] ? [bits0]
        VTOV    minus_big, [tout] ? [bits0]
        VTOV    minus_big, [tin] ? [bits1]
        VTOV    big, [tout] ? [bits1]
plane_crossed:
        BIM     0, link_kernel
        .endkernel
