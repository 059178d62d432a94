; normal_sphere.s - computes the normal of a sphere (normal_vector.s).

        .kernel shade
; N = (X - C) / r.
normal_sphere:
        load_shape 5
        scaled_lower_three qx, sh0, nx, qy, sh1, ny, qz, sh2, nz, sh4
        leave_normal
        .endkernel
