; normal_sphere.s - computes the normal of a sphere (normal_vector.s).

        .kernel shade
; N = (X - C) / r.
normal_sphere:
        load_shape 5
        lowered_scale_three qx, sh0, sh4, nx, qy, sh1, sh4, ny, qz, sh2, sh4, nz
        leave_normal
        .endkernel
