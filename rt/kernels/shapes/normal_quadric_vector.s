; normal_quadric_vector.s - computes the normals of quadrics (normal_vector.s).

        .kernel shade
; N = A (X - C) + g, normalised.
normal_quadric:
        load_record P_SHAPE, 13, sh0
        SUBNV   [qx], sh0, [v0]
        SUBNV   [qy], sh1, [v1]
        SUBNV   [qz], sh2, [v2]
        quadric_rows v0, v1, v2, nx, ny, nz, v3
        ADDNV   [nx], sh9, [nx]
        ADDNV   [ny], sh10, [ny]
        ADDNV   [nz], sh11, [nz]
; Normalises a gradient.  A zero gradient, at an apex, becomes x.
gradient_normal:
        dot_vectors nx, ny, nz, nx, ny, nz, v0, v1
        CMPEQV  [v0], r0, [hits0]
        VTOV    one, [v0] ? [hits0]
        VTOV    one, [nx] ? [hits0]
        SQRTV   [v0], [v0]
        DIVSV   one, [v0], [v0]
        MPYSV   [nx], [v0], [nx]
        MPYSV   [ny], [v0], [ny]
        MPYSV   [nz], [v0], [nz]
        BIM     0, link_kernel
        .endkernel
