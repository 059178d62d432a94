; normal_plane_vector.s - sets the normals of planes (normal_vector.s).

        .kernel shade
normal_plane:
        load_record P_SHAPE, 3, sh0
        VTOV    sh0, [nx]
        VTOV    sh1, [ny]
        VTOV    sh2, [nz]
        BIM     0, link_kernel
        .endkernel
