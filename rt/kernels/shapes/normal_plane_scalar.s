; normal_plane_scalar.s - sets the normal of a plane (normal_plane_vector.s).

        .kernel shade
normal_plane:
        load_shape 3
        RTOR    sh0, nx
        RTOR    sh1, ny
        RTOR    sh2, nz
        BIM     0, normal_link
        .endkernel
