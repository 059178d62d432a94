; disc_vector.s - intersects a queue of rays with a disc or a ring: the points X
; of a plane with r <= |X - C| <= R.
;
; The crossing t with the plane is that of plane_vector.s.  With L = O - C,
;
;   r^2 <= (L + t D) . (L + t D) <= R^2
;
; In a Boolean tree the inside of a disc is the half space below its plane; the
; kernel of the plane computes that.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin = tout = t; a miss is big, minus_big.
; Source: textbook; the definition of its inside is POV-Ray's.

        .macro  disc_axis o, d, center, into
        SUBNV   [\o], \center, [\into]
        MPYSV   [w2], [\d], [w3]
        ADDNV   [w3], [\into], [\into]
        .endm

        .kernel disc
disc:
        load_record P_SHAPE, 9, sh0
        intersect_plane
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
