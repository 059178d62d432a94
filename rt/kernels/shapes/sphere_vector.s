; sphere_vector.s - intersects a queue of rays with a sphere.
;
; With L = C - O, D of length one:
;
;   b = L . D              distance to the closest approach to the centre
;   w = b D - L            from the centre to that point
;   h = r^2 - w . w        h < 0: the ray misses
;   tin = b - sqrt(h),  tout = b + sqrt(h)
;
; w is computed as a vector.  L.L - b^2 would cancel for a small and distant
; sphere in 47 bits.
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: the project's notes on ray tracing, 4.2; the paper's Table 1 allows
; 28 results per ray.

; Computes [in], [out] of rays with the directions [d], in the lanes of bits.  L
; is in [l0], [l1], [l2], which change.
        .macro  sphere_segment l0, l1, l2, d0, d1, d2, r2, b, work, in, out, bits
        dot_vectors \l0, \l1, \l2, \d0, \d1, \d2, \b, \work
        MPYSV   [\b], [\d0], [\work]
        SUBNV   [\work], [\l0], [\l0]
        MPYSV   [\b], [\d1], [\work]
        SUBNV   [\work], [\l1], [\l1]
        MPYSV   [\b], [\d2], [\work]
        SUBNV   [\work], [\l2], [\l2]
        MPYSV   [\l0], [\l0], [\l0]
        MPYSV   [\l1], [\l1], [\l1]
        ADDNV   [\l1], [\l0], [\l0]
        MPYSV   [\l2], [\l2], [\l2]
        ADDNV   [\l2], [\l0], [\l1]
        SUBNV   \r2, [\l1], [\l0]
        VTOV    big, [\in]
        VTOV    minus_big, [\out]
        CMPGEV  [\l0], r0, [\bits]
        SQRTV   [\l0], [\l0] ? [\bits]
        SUBNV   [\b], [\l0], [\in] ? [\bits]
        ADDNV   [\b], [\l0], [\out] ? [\bits]
        .endm

        .kernel sphere
sphere:
        load_record P_SHAPE, 4, sh0
        SUBNV   sh0, [ox], [w0]
        SUBNV   sh1, [oy], [w1]
        SUBNV   sh2, [oz], [w2]
        sphere_segment w0, w1, w2, dx, dy, dz, sh3, w3, w4, tin, tout, bits0
        BIM     0, link_kernel
        .endkernel
