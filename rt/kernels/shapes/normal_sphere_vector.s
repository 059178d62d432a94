; normal_sphere_vector.s - computes the normals of spheres (normal_vector.s).

        .kernel shade
; N = (X - C) / r.
normal_sphere:
        load_record P_SHAPE, 5, sh0
        LINKV
        SUBNV   [qx], sh0, [nx]
        MPYSV   [nx], sh4, [nx]
        LINKV
        SUBNV   [qy], sh1, [ny]
        MPYSV   [ny], sh4, [ny]
        LINKV
        SUBNV   [qz], sh2, [nz]
        MPYSV   [nz], sh4, [nz]
        BIM     0, link_kernel
        .endkernel
