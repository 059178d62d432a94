; normal_sphere_scalar.s - computes the normal of a sphere
; (normal_sphere_vector.s).

        .kernel shade
normal_sphere:
        load_shape 5
        SUBN    qx, sh0, nx
        SUBN    qy, sh1, ny
        SUBN    qz, sh2, nz
        MPYS    nx, sh4, nx
        MPYS    ny, sh4, ny
        MPYS    nz, sh4, nz
        BIM     0, normal_link
        .endkernel
