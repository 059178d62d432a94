; cylinder_half_spaces_vector.s - cuts a queue of rays at the ends of a cylinder
; as two half spaces.
;
; This is one of the formulations that were tried for Table 1 (docs/table1.md).
; The side is computed as in cylinder_vector.s.  Each end is a half space, whose
; segment of the ray is computed as in plane.s.  The result is the
; maximum of the entries and the minimum of the exits.

; Intersects tin, tout with the half space o + t d <= at.
        .macro  half_space o, d, at
        SUBNV   \at, [\o], [w0]
        CMPLTV  |[\d]|, tiny, [bits0]
        MASKV   one, [\d], [w1] ? [bits0]
        DIVSV   [w0], [w1], [w2]
        CMPLTV  [w1], r0, [bits1]
        MASKV   [w2], minus_big, [w3] ? [bits1]
        MASKV   big, [w2], [w4] ? [bits1]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, space_crossed\@
        CMPGEV  [w0], r0, [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [w3] ? [bits0]
        VTOV    minus_big, [w4] ? [bits0]
        VTOV    minus_big, [w3] ? [bits1]
        VTOV    big, [w4] ? [bits1]
space_crossed\@:
        CMPLTV  [tin], [w3], [bits1]
        VTOV    [w3], [tin] ? [bits1]
        CMPLTV  [w4], [tout], [bits1]
        VTOV    [w4], [tout] ? [bits1]
        .endm

        .macro  cut_by_ends
        half_space w5, w6, sh13
        VTOV    -[w5], [w5]
        VTOV    -[w6], [w6]
        half_space w5, w6, sh13
        .endm
