; cone_vector.s - a queue of rays meets a cone or a frustum of one.
;
; In the frame u, v, w (w along the axis) with its origin at the middle of the
; axis the side is  u^2 + v^2 = r(w)^2,  r(w) = r0 + k w, between w = -half and
; half.  With the ray's origin moved to o, its closest approach to that middle,
; and d its direction:
;
;   a = du^2 + dv^2 - (k dw)^2
;   b = ou du + ov dv - r(ow) k dw
;   c = ou^2 + ov^2 - r(ow)^2      roots of a t^2 + 2 b t + c
;
; a > 0: the ray is inside the side between the two roots.  a < 0: outside
; between them; they lie on the two halves of the double cone, and the ray
; stays in the half it goes towards (k dw > 0) or comes from.  There is always
; a root then: disc < 0 is the rounding of a ray through the apex.  a = 0: along
; a line of the side; it is inside behind the one root (b < 0) or before it;
; without one (b = 0: along the axis of equal radii) for ever or never.  A solid
; cone is cut by the slab of its two disks, which leaves nothing of the second
; half; an open one keeps those of its crossings that lie between them.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: derived here; the project's notes on ray tracing, 4.1 and 4.2.

; The side: tin, tout, bits0 = real; a miss is big, minus_big.  Leaves o along
; w in [w5], d along w in [w6], the shift of the origin in [w9], a in [w10];
; [w3] > 0 where a ray with a <= 0 goes inside.
        .macro  cone_side
        load_record P_SHAPE, 15, sh0
        SUBNV   [ox], sh0, [w0]
        SUBNV   [oy], sh1, [w1]
        SUBNV   [oz], sh2, [w2]
        closest_approach w0, w1, w2, w0, w1, w2, w9, w3
        dot_constant w0, w1, w2, sh3, sh4, sh5, w7, w3
        dot_constant w0, w1, w2, sh6, sh7, sh8, w8, w3
        dot_constant w0, w1, w2, sh9, sh10, sh11, w5, w3
        dot_constant dx, dy, dz, sh3, sh4, sh5, w0, w3
        dot_constant dx, dy, dz, sh6, sh7, sh8, w1, w3
        dot_constant dx, dy, dz, sh9, sh10, sh11, w6, w3
        LINKV
        MPYSV   [w5], sh13, [w2]
        ADDNV   [w2], sh12, [w2]                ; r(ow)
        MPYSV   [w6], sh13, [w3]                ; k dw
        MPYSV   [w0], [w0], [w10]
        MPYSV   [w1], [w1], [w4]
        ADDNV   [w4], [w10], [w10]
        MPYSV   [w3], [w3], [w4]
        SUBNV   [w10], [w4], [w10]              ; a
        MPYSV   [w7], [w0], [w11]
        MPYSV   [w8], [w1], [w4]
        ADDNV   [w4], [w11], [w11]
        MPYSV   [w2], [w3], [w4]
        SUBNV   [w11], [w4], [w11]              ; b
        MPYSV   [w7], [w7], [w4]
        MPYSV   [w8], [w8], [w7]
        ADDNV   [w7], [w4], [w4]
        MPYSV   [w2], [w2], [w2]
        SUBNV   [w4], [w2], [w4]                ; c
        discriminant w10, w11, w4, w2, w0
        CMPLTV  [w10], r0, [bits0]
        CMPLTV  [w2], r0, [bits1]
        ANDB    [bits0], [bits1], [bits0]
        VTOV    r0, [w2] ? [bits0]
        quadratic_roots w10, w11, w4, w2, w0, w1
        ORB     [bits1], [bits2], [bits1]
        CNTOB   [bits1], s0
        IBXEQ   s0, r0, r0, cone_rooted\@
        CMPEQV  [w10], r0, [bits1]
        VTOV    [w0], [w1] ? [bits2]
        VTOV    [w1], [w0] ? [bits1]
        VTOV    -[w11], [w3] ? [bits1]
        ANDB    [bits1], [bits2], [bits2]       ; no root
        VTOV    minus_big, [w0] ? [bits2]
        VTOV    big, [w1] ? [bits2]
        VTOV    one, [w10] ? [bits2]            ; inside between these
        CMPLTV  r0, [w4], [bits1]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits0], [bits1], [bits0]       ; or never
cone_rooted\@:
        sort_roots w0, w1
        VTOV    big, [tin] ?! [bits0]
        VTOV    minus_big, [tout] ?! [bits0]
        .endm

        .kernel cone
cone:
        cone_side
        CMPGEV  r0, [w10], [bits1]
        ANDB    [bits0], [bits1], [bits0]       ; outside between the roots
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, cone_cut
        CMPLTV  r0, [w3], [bits1]
        ANDNB   [bits0], [bits1], [bits2]       ; comes from there
        VTOV    [tin], [tout] ? [bits2]
        VTOV    minus_big, [tin] ? [bits2]
        ANDB    [bits0], [bits1], [bits2]       ; goes there
        VTOV    [tout], [tin] ? [bits2]
        VTOV    big, [tout] ? [bits2]
cone_cut:
        SUBN    r0, sh14, s1
        slab    w5, w6, s1, sh14
        close_segment
        move_back w9
        BIM     0, link_kernel

open_cone:
        cone_side
        keep_between_disks sh14
        move_back w9
        BIM     0, link_kernel
        .endkernel
