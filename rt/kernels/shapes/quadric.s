; quadric.s - intersects rays with a quadric:
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
;       CALL QUADRIC (RAY, PRIMITIVE, SEGMENT)
;       CALL QUADRIC_SOLID (RAY, PRIMITIVE, SEGMENTS)
;
; In:  ox oy oz dx dy dz; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.  quadric_solid: the two segments of
;      the ray inside, where the polynomial is below 0.
; Record: centre 3, matrix xx yy zz xy xz yz, half of the linear terms 3,
;         constant, about the centre.
; Source: derived here; the project's notes on ray tracing, 4.2.

; Computes a, b, c, and t2 = b^2 - a c.
        .macro  quadric_polynomial
        enter_shape quadric, index_one
        three   ray_lower, ox, oy, oz, sh0, sh1, sh2, t0, t1, t2
        closest_approach t0, t1, t2, t0, t1, t2, shift, t3, t4
        times_matrix dx, dy, dz, t7, t8, t9, t3, t4, t5, t6
        dot_vectors dx, dy, dz, t7, t8, t9, quad_a, t3
        times_matrix t0, t1, t2, t7, t8, t9, t3, t4, t5, t6
        three   ray_raise, t7, t8, t9, sh9, sh10, sh11, t7, t8, t9
        dot_vectors dx, dy, dz, t7, t8, t9, quad_b, t3
        three   ray_raise, t7, t8, t9, sh9, sh10, sh11, t7, t8, t9
        dot_vectors t0, t1, t2, t7, t8, t9, quad_c, t3
        ray_raise quad_c, sh12, quad_c
        discriminant quad_a, quad_b, quad_c, t2, t0
        .endm

        shape_record quadric, 13, 62, index_one ; after quad_c
        .kernel quadric
quadric:
        quadric_polynomial
        quadric_roots quadric_missed
        crossings_or_miss
        leave_shape index_one
        missed  quadric_missed, index_one

quadric_solid:
        quadric_polynomial
        quadric_segments
        leave_shape index_one
        .endkernel
