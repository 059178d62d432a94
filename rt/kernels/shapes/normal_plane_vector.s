; normal_plane_vector.s - the normals of planes; see normal_vector.s.

        .kernel shade
; Plane: its own.
normal_plane:
        load_record P_SHAPE, 3, sh0
        VTOV    sh0, [nx]
        VTOV    sh1, [ny]
        VTOV    sh2, [nz]
        BIM     0, link_kernel
        .endkernel
