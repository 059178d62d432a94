; disc_vector.s - a queue of rays meets a disc, or a ring: the X of a plane with
; r <= |X - C| <= R.
;
; The plane is met as in plane_vector.s, at t; with L = O - C,
;
;   r^2 <= (L + t D) . (L + t D) <= R^2
;
; In a tree what lies below its plane is inside of it: the plane's kernel tells
; that.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin = tout = t; a miss is big, minus_big.
; Source: textbook; what is inside of it is POV-Ray's.

        .macro  disc_axis o, d, center, into
        SUBNV   [\o], \center, [\into]
        MPYSV   [w2], [\d], [w3]
        ADDNV   [w3], [\into], [\into]
        .endm

        .kernel disc
disc:
        load_record P_SHAPE, 9, sh0
        meet_plane
        disc_axis ox, dx, sh4, w4
        disc_axis oy, dy, sh5, w5
        disc_axis oz, dz, sh6, w6
        dot_vectors w4, w5, w6, w4, w5, w6, w7, w3
        CMPGEV  sh7, [w7], [bits1]
        CMPGEV  [w7], sh8, [bits2]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits1], [bits0], [bits1]
        MASKV   [w2], big, [tin] ? [bits1]
        MASKV   [w2], minus_big, [tout] ? [bits1]
        BIM     0, link_kernel
        .endkernel
