; cylinder_vector.s - intersects a queue of rays with a circular cylinder.
;
; The frame is u, v, w (w along the axis) with its origin at the middle of the
; axis.  o and d are the ray's origin and direction in it.  Across the axis:
;
;   a = du^2 + dv^2               t0 = -(ou du + ov dv) / a
;   c = o + t0 d                  the closest approach to the axis
;   h = (r^2 - cu^2 - cv^2) / a   h < 0: the ray misses
;   side: t0 - sqrt(h), t0 + sqrt(h)
;
; The quadratic is solved about the closest approach, so that nothing cancels
; for distant origins.  a < tiny^2: the ray is parallel to the axis and inside
; the side everywhere or nowhere.  The slab of its two disks cuts a solid
; cylinder; an open one keeps those of its two crossings that lie between them.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: the project's notes on ray tracing, 4.2.

; The ray in the frame u, v, w: o = w7, w8, w5; d = w0, w1, w6.  Changes w2, w9.
        .macro  into_frame
        three   SUBNV, [ox], [oy], [oz], sh0, sh1, sh2, [w0], [w1], [w2]
        dot_constants w0, w1, w2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, w7, w8, w5, w9
        dot_constants dx, dy, dz, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10, sh11, w0, w1, w6, w9
        .endm

; Computes tin, tout of the side of the infinite cylinder.  Leaves o along w in
; [w5], d along w in [w6].
        .macro  cylinder_side
        into_frame
        MPYSV   [w0], [w0], [w2]
        MPYSV   [w1], [w1], [w3]
        ADDNV   [w3], [w2], [w2]
        MPYS    tiny, tiny, s0
        CMPLTV  [w2], s0, [bits0]
        MASKV   one, [w2], [w2] ? [bits0]
        DIVSV   one, [w2], [w2]
        MPYSV   [w7], [w0], [w3]
        MPYSV   [w8], [w1], [w4]
        ADDNV   [w4], [w3], [w3]
        MPYSV   -[w3], [w2], [w3]
        MPYSV   [w3], [w0], [w0]
        ADDNV   [w7], [w0], [w0]
        MPYSV   [w3], [w1], [w1]
        ADDNV   [w8], [w1], [w1]
        MPYSV   [w0], [w0], [w0]
        MPYSV   [w1], [w1], [w1]
        ADDNV   [w1], [w0], [w4]
        LINKV
        SUBNV   sh12, [w4], [w0]
        MPYSV   [w0], [w2], [w0]
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        CMPGEV  [w0], r0, [bits1]
        SQRTV   [w0], [w0] ? [bits1]
        SUBNV   [w3], [w0], [tin] ? [bits1]
        ADDNV   [w3], [w0], [tout] ? [bits1]
        if_none bits0, s0, cylinder_crossed\@
        MPYSV   [w7], [w7], [w7]
        MPYSV   [w8], [w8], [w8]
        ADDNV   [w8], [w7], [w7]
        CMPGEV  sh12, [w7], [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [tin] ? [bits0]
        VTOV    minus_big, [tout] ? [bits0]
        VTOV    minus_big, [tin] ? [bits1]
        VTOV    big, [tout] ? [bits1]
cylinder_crossed\@:
        .endm

        .ifdef  CYLINDER_HALF_SPACES
        .include "shapes/cylinder_half_spaces.s"
        .else
        .macro  cut_by_ends
        SUBN    r0, sh13, s1
        slab    w5, w6, s1, sh13
        .endm
        .endif

        .kernel cylinder
        .ifndef CYLINDER_IN_FRAME
cylinder:
        load_record P_SHAPE, 14, sh0
        cylinder_side
        cut_by_ends
        close_segment
        BIM     0, link_kernel
        .endif

; Keeps those of the crossings tin and tout that lie between the disks, at most
; half from the middle; o, d = the ray along the axis.  Changes w0-w2,
; bits0-bits2.
        .macro  between_disks t, o, d, half, bits
        MPYSV   [\t], [\d], [w0]
        ADDNV   [w0], [\o], [w0]
        CMPGEV  \half, |[w0]|, [\bits]
        ANDB    [\bits], [bits2], [\bits]
        .endm

        .macro  keep_between_disks o, d, half, miss=
        CMPGEV  [tout], [tin], [bits2]
        between_disks tin, \o, \d, \half, bits0
        between_disks tout, \o, \d, \half, bits1
        VTOV    [tin], [w1]
        VTOV    [tout], [w2]
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        VTOV    [w2], [tin] ? [bits1]
        VTOV    [w1], [tin] ? [bits0]
        VTOV    [w1], [tout] ? [bits0]
        VTOV    [w2], [tout] ? [bits1]
        .endm

open_cylinder:
        load_record P_SHAPE, 14, sh0
        cylinder_side
        keep_between_disks w5, w6, sh13
        BIM     0, link_kernel
        .endkernel
