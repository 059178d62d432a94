; quadric_vector.s - intersects a queue of rays with a quadric:
;
;   f(X) = X A X + 2 g X + k = 0,  A symmetric, X relative to the shape's centre
;   (or to a point of its axis, for paraboloids have no centre).
;
; With o, the ray's closest approach to the centre, as its origin:
;
;   h = A o + g,   a = D A D,   b = D h,   c = o (h + g) + k
;
; The crossings are the roots of a t^2 + 2 b t + c.  A quadric can contain the
; part before one crossing and after the other.  Therefore tin, tout are not a
; segment here but the two crossings, the smaller first; the nearest one ahead
; is then chosen as for all shapes.  With one root (a = 0) tin = tout.
;
; In:  ox oy oz dx dy dz, near long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.  quadric_solid: two segments.
; Source: derived here; the project's notes on ray tracing, 4.2.

; y = A x for the matrix of the record.
        .macro  quadric_rows x0, x1, x2, y0, y1, y2, work
        dot_constant \x0, \x1, \x2, sh3, sh6, sh7, \y0, \work
        dot_constant \x0, \x1, \x2, sh6, sh4, sh8, \y1, \work
        dot_constant \x0, \x1, \x2, sh7, sh8, sh5, \y2, \work
        .endm

; Computes the polynomial (a, b, c in w10, w11, w7) and its roots tin, tout in
; the lanes of bits0, relative to the closest approach.  [w9] = the shift of the
; origin.
        .macro  quadric_polynomial
        load_record P_SHAPE, 13, sh0
        SUBNV   [ox], sh0, [w0]
        SUBNV   [oy], sh1, [w1]
        SUBNV   [oz], sh2, [w2]
        closest_approach w0, w1, w2, w0, w1, w2, w9, w3
        quadric_rows dx, dy, dz, w4, w5, w6, w3
        dot_vectors dx, dy, dz, w4, w5, w6, w10, w3
        quadric_rows w0, w1, w2, w4, w5, w6, w3
        ADDNV   [w4], sh9, [w4]
        ADDNV   [w5], sh10, [w5]
        ADDNV   [w6], sh11, [w6]
        dot_vectors dx, dy, dz, w4, w5, w6, w11, w3
        ADDNV   [w4], sh9, [w4]
        ADDNV   [w5], sh10, [w5]
        ADDNV   [w6], sh11, [w6]
        dot_vectors w0, w1, w2, w4, w5, w6, w7, w3
        ADDNV   [w7], sh12, [w7]
        discriminant w10, w11, w7, w2, w0
        quadratic_roots w10, w11, w7, w2, w0, w1
        ORB     [bits1], [bits2], [bits1]
        CNTOB   [bits1], s0
        IBXEQ   s0, r0, r0, quadric_rooted\@
        CMPEQV  [w10], r0, [bits1]
        VTOV    [w0], [w1] ? [bits2]
        VTOV    [w1], [w0] ? [bits1]
        ANDB    [bits1], [bits2], [bits1]
        ANDNB   [bits0], [bits1], [bits0]       ; lanes without a root
quadric_rooted\@:
        sort_roots w0, w1
        .endm

        .kernel quadric
quadric:
        quadric_polynomial
        VTOV    big, [tin] ?! [bits0]
        VTOV    minus_big, [tout] ?! [bits0]
        move_back w9
        BIM     0, link_kernel

; Two crossings: the ray is inside between them or, if a < 0, before the first
; and after the second.  One crossing (a = 0): it is inside before it if the
; polynomial rises.  None: it is inside everywhere or nowhere, by the sign of a
; or, if a = b = 0, of c.
quadric_solid:
        quadric_polynomial
        SUBNV   [tin], [w9], [tin]
        SUBNV   [tout], [w9], [tout]
        VTOV    big, [tin2]
        VTOV    minus_big, [tout2]
        VTOV    big, [tin] ?! [bits0]
        VTOV    minus_big, [tout] ?! [bits0]
        CMPLTV  r0, [w10], [bits1]
        CNTOB   [bits1], s0
        IBXEQ   s0, r0, near, solid_stored      ; a > 0 for all
        CMPLTV  [w10], r0, [bits1]              ; a < 0
        ANDB    [bits0], [bits1], [bits2]
        VTOV    [tout], [tin2] ? [bits2]
        VTOV    big, [tout2] ? [bits2]
        VTOV    [tin], [tout] ? [bits2]
        VTOV    minus_big, [tin] ? [bits2]
        ANDNB   [bits1], [bits0], [bits2]
        VTOV    minus_big, [tin] ? [bits2]
        VTOV    big, [tout] ? [bits2]
        CMPEQV  [w10], r0, [bits1]
        CNTOB   [bits1], s0
        IBXEQ   s0, r0, r0, solid_stored
        ANDB    [bits0], [bits1], [bits0]       ; a = 0: one crossing
        ANDNB   [bits1], [bits0], [bits1]       ; a = 0: no crossing
        CMPGEV  [w11], r0, [bits2]
        ANDNB   [bits0], [bits2], [bits2]       ; the polynomial falls
        VTOV    big, [tout] ? [bits2]
        CMPGEV  [w11], r0, [bits2]
        ANDB    [bits0], [bits2], [bits2]       ; the polynomial rises
        VTOV    minus_big, [tin] ? [bits2]
        CMPLTV  [w7], r0, [bits2]
        ANDB    [bits1], [bits2], [bits2]       ; inside everywhere
        VTOV    minus_big, [tin] ? [bits2]
        VTOV    big, [tout] ? [bits2]
solid_stored:
        BIM     0, link_kernel
        .endkernel
