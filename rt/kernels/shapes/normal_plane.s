; normal_plane.s - sets the normal of a plane (normal_vector.s).

        .kernel shade
normal_plane:
        load_shape 3
        set     sh0, nx
        set     sh1, ny
        set     sh2, nz
        leave_normal
        .endkernel
