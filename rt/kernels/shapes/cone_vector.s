; cone_vector.s - intersects a queue of rays with a cone or frustum.
;
; The frame is u, v, w (w along the axis) with its origin at the middle of the
; axis.  The side is  u^2 + v^2 = r(w)^2,  r(w) = r0 + k w,  between w = -half
; and half.  o is the ray's closest approach to that middle and d its direction:
;
;   a = du^2 + dv^2 - (k dw)^2
;   b = ou du + ov dv - r(ow) k dw
;   c = ou^2 + ov^2 - r(ow)^2      roots of a t^2 + 2 b t + c
;
; a > 0: the ray is inside the side between the two roots.
; a < 0: it is outside between them.  They lie on the two halves of the double
;   cone; the ray comes from inside one half and goes into the other.  The half
;   with r > 0 is the one after the second root if k dw > 0, else the one before
;   the first.  There is always a root: a negative discriminant is the rounding
;   of a ray through the apex.
; a = 0: it is parallel to a line of the side, and inside after the one root
;   (b < 0) or before it.  Without a root (b = 0: along the axis of equal radii)
;   it is inside everywhere or nowhere.
;
; The slab of its two disks cuts a solid cone, so nothing remains of the other
; half.  An open cone keeps those of its crossings that lie between the disks.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: derived here; the project's notes on ray tracing, 4.1 and 4.2.

; Computes tin, tout of the side, bits0 = the lanes that hit it; a miss is big,
; minus_big.  Also sets [w5], [w6] = o, d along w; [w9] = the shift of the
; origin; [w10] = a.  [w3] > 0: a ray with a <= 0 ends inside.
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
        ANDB    [bits1], [bits2], [bits2]       ; lanes without a root
        VTOV    minus_big, [w0] ? [bits2]
        VTOV    big, [w1] ? [bits2]
        VTOV    one, [w10] ? [bits2]            ; inside between these
        CMPLTV  r0, [w4], [bits1]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits0], [bits1], [bits0]       ; outside everywhere
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
        ANDNB   [bits0], [bits1], [bits2]       ; inside before the first root
        VTOV    [tin], [tout] ? [bits2]
        VTOV    minus_big, [tin] ? [bits2]
        ANDB    [bits0], [bits1], [bits2]       ; inside after the last root
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
