; sphere_vector.s - a queue of rays meets a sphere.
;
; With L = C - O, D of length one:
;
;   b = L . D              distance to the closest approach to the centre
;   w = b D - L            from the centre to that point
;   h = r^2 - w . w        h < 0: the ray misses
;   tin = b - sqrt(h),  tout = b + sqrt(h)
;
; w is formed as a vector, not L.L - b^2, which cancels for a small and
; distant sphere in 47 bits.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: the project's notes on ray tracing, 4.2; the paper's Table 1 allows
; 28 results a ray.

        .kernel sphere
sphere:
        load_record P_SHAPE, 4, sh0
        SUBNV   sh0, [ox], [w0]
        SUBNV   sh1, [oy], [w1]
        SUBNV   sh2, [oz], [w2]
        dot_vectors w0, w1, w2, dx, dy, dz, w3, w4
        MPYSV   [w3], [dx], [w4]
        SUBNV   [w4], [w0], [w0]
        MPYSV   [w3], [dy], [w4]
        SUBNV   [w4], [w1], [w1]
        MPYSV   [w3], [dz], [w4]
        SUBNV   [w4], [w2], [w2]
        MPYSV   [w0], [w0], [w0]
        MPYSV   [w1], [w1], [w1]
        ADDNV   [w1], [w0], [w0]
        MPYSV   [w2], [w2], [w2]
        ADDNV   [w2], [w0], [w1]
        SUBNV   sh3, [w1], [w0]
        VTOV    big, [tin]
        VTOV    minus_big, [tout]
        CMPGEV  [w0], r0, [bits0]
        SQRTV   [w0], [w0] ? [bits0]
        SUBNV   [w3], [w0], [tin] ? [bits0]
        ADDNV   [w3], [w0], [tout] ? [bits0]
        BIM     0, link_kernel
        .endkernel
