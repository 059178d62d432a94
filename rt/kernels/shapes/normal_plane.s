; normal_plane.s - sets the normal of a plane (normal_vector.s).

        .kernel shade
normal_plane:
        load_shape 3
        copy_three sh0, sh1, sh2, nx, ny, nz, set
        leave_normal
        .endkernel
