; normal_torus_vector.s - computes the normals of tori of any kind
; (normal_vector.s).

        .kernel shade
; The normal is the gradient of (x^2 + z^2 + rho y^2 + b0)^2 - a0 (x^2 + z^2).
; With g = x^2 + z^2 + rho y^2 + b0:  N = ((g - a0/2) x, rho g y, (g - a0/2) z).
normal_torus:
        load_record P_SHAPE, 4, sh0
        MPYSV   [qx], [qx], [v0]
        MPYSV   [qz], [qz], [v1]
        ADDNV   [v1], [v0], [v0]
        MPYSV   [qy], [qy], [v1]
        LINKV
        MPYSV   [v1], sh0, [v1]
        ADDNV   [v1], [v0], [v0]
        ADDNV   [v0], sh1, [v0]                 ; g
        MPYSV   [v0], [qy], [v1]
        MPYSV   [v1], sh0, [ny]
        SUBNV   [v0], sh3, [v0]
        MPYSV   [v0], [qx], [nx]
        MPYSV   [v0], [qz], [nz]
        BIM     gradient_normal
        .endkernel
