; cylinder_clipped_vector.s - intersects a queue of rays with a cylinder by the
; method that one of the paper's authors published later: the distance between
; ray and axis, then clipping by two planes.  It records the surfaces of entry
; and exit.
;
; With base B, unit axis A and radius r, and a ray from O along D:
;
;   N = D x A,  n = |N|            n = 0: the ray is parallel to the axis,
;                                  inside everywhere or nowhere, by |(O - B) x
;                                  A|
;   N := N / |N|                   a second length and three divisions
;   d = |(O - B) . N|              distance from axis to ray; d > r: a miss
;   t = -((O - B) x A) . N / n     the closest approach
;   Q = N x A,  Q := Q / |Q|
;   s = |sqrt(r^2 - d^2) / (D . Q)|
;   in = t - s,  out = t + s
;
; Each end is a plane p, q of any direction.  Its inside is p . X + q < 0:
;
;   t = -(p . O + q) / (p . D)
;
; p . D < 0: the ray enters there, and in becomes max(in, t).  p . D > 0: the
; ray leaves there, and out becomes min(out, t).  out < in is a miss.
; |p . D| < tiny: the ray is parallel, inside everywhere or nowhere.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big; if there is a crossing, patch_s
;      is the surface of the entry and patch_t that of the exit: 0 the side,
;      1 the bottom, 2 the top.
; Source: J. M. Cychosz and W. N. Waggenspack, Intersecting a Ray with a
; Cylinder, Graphics Gems IV (1994) 356-365; the program is this project's.

        .macro  record_surface surface, where, bits
        .ifndef CYLINDER_UNRECORDED
        VTOV    \surface, [\where] ? [\bits]
        .endif
        .endm

        .macro  length x0, x1, x2, sum, work
        dot_vectors \x0, \x1, \x2, \x0, \x1, \x2, \sum, \work
        SQRTV   [\sum], [\sum]
        .endm

        .macro  make_unit x0, x1, x2, sum, work
        .ifdef  CYLINDER_RECIPROCALS
        normalise \x0, \x1, \x2, \sum, \work
        .else
        length  \x0, \x1, \x2, \sum, \work
        DIVSV   [\x0], [\sum], [\x0]
        DIVSV   [\x1], [\sum], [\x1]
        DIVSV   [\x2], [\sum], [\x2]
        .endif
        .endm

; from_base: O - B.  across_axis: the cross product of a vector and the axis.
        .macro  from_base x0, x1, x2
        SUBNV   [ox], sh0, [\x0]
        SUBNV   [oy], sh1, [\x1]
        SUBNV   [oz], sh2, [\x2]
        .endm

        .macro  across_axis x0, x1, x2, c0, c1, c2, work
        cross_constant \x0, \x1, \x2, sh3, sh4, sh5, \c0, \c1, \c2, \work
        .endm

; Computes tin, tout of the infinite cylinder.
        .macro  find_side
        from_base w4, w5, w6
        across_axis dx, dy, dz, w0, w1, w2, w8
        length  w0, w1, w2, w3, w8
        CMPLTV  [w3], tiny, [bits0]
        MASKV   one, [w3], [w3] ? [bits0]
        make_unit w0, w1, w2, w7, w8
        dot_vectors w4, w5, w6, w0, w1, w2, w7, w8
        CMPGEV  sh6, |[w7]|, [bits1]
        across_axis w4, w5, w6, w9, w10, w11, w8
        dot_vectors w9, w10, w11, w0, w1, w2, w4, w8
        DIVSV   -[w4], [w3], [w9]
        across_axis w0, w1, w2, w4, w5, w6, w8
        make_unit w4, w5, w6, w3, w8
        dot_vectors dx, dy, dz, w4, w5, w6, w3, w8
        MPYS    sh6, sh6, s0
        LINKV
        MPYSV   [w7], [w7], [w7]
        SUBNV   s0, [w7], [w7]
        SQRTV   [w7], [w7] ? [bits1]
        DIVSV   [w7], [w3], [w7]
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        SUBNV   [w9], |[w7]|, [tin] ? [bits1]
        ADDNV   [w9], |[w7]|, [tout] ? [bits1]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, side_crossed\@
        from_base w4, w5, w6
        across_axis w4, w5, w6, w0, w1, w2, w8
        length  w0, w1, w2, w3, w8
        CMPGEV  sh6, [w3], [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [tin] ? [bits0]
        VTOV    minus_big, [tout] ? [bits0]
        VTOV    minus_big, [tin] ? [bits1]
        VTOV    big, [tout] ? [bits1]
side_crossed\@:
        .ifndef CYLINDER_UNRECORDED
        VTOV    r0, [patch_s]
        VTOV    r0, [patch_t]
        .endif
        .endm

; Clips the rays by a plane.  The t of a ray parallel to the plane is set so
; that it changes nothing or makes the ray a miss.
        .macro  clip p0, p1, p2, q, surface
        dot_constant dx, dy, dz, \p0, \p1, \p2, w0, w2
        dot_constant ox, oy, oz, \p0, \p1, \p2, w1, w2
        ADDNV   [w1], \q, [w1]
        CMPLTV  |[w0]|, tiny, [bits0]
        MASKV   one, [w0], [w0] ? [bits0]
        DIVSV   -[w1], [w0], [w2]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, clip_crossed\@
        CMPLTV  r0, [w1], [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [w2] ? [bits0]
        VTOV    minus_big, [w2] ? [bits1]
clip_crossed\@:
        CMPLTV  [w0], r0, [bits0]
        CMPLTV  [tin], [w2], [bits1]
        CMPLTV  [w2], [tout], [bits2]
        ANDB    [bits1], [bits0], [bits1]
        ANDNB   [bits2], [bits0], [bits2]
        VTOV    [w2], [tin] ? [bits1]
        record_surface    \surface, patch_s, bits1
        VTOV    [w2], [tout] ? [bits2]
        record_surface    \surface, patch_t, bits2
        .endm

        .macro  find_clipped
        load_record P_SHAPE, 15, sh0
        find_side
        clip    sh7, sh8, sh9, sh10, one
        clip    sh11, sh12, sh13, sh14, two
        .endm

        .kernel cylinder
clipped_cylinder:
        find_clipped
        close_segment
        BIM     0, link_kernel

        .ifndef CYLINDER_UNRECORDED
; Keeps the crossings with the side.  A single one is both entry and exit.
open_clipped_cylinder:
        find_clipped
        CMPLTV  [tout], [tin], [bits0]
        CMPEQV  [patch_s], r0, [bits1]
        CMPEQV  [patch_t], r0, [bits2]
        VTOV    [tin], [w0]
        VTOV    [tout], [tin] ?! [bits1]
        VTOV    [w0], [tout] ?! [bits2]
        ORB     [bits1], [bits2], [bits1]
        ORNB    [bits0], [bits1], [bits0]
        VTOV    big, [tin] ? [bits0]
        VTOV    minus_big, [tout] ? [bits0]
        BIM     0, link_kernel
        .endif
        .endkernel
