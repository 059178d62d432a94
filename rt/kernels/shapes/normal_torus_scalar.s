; normal_torus_scalar.s - computes the normal of a torus of any kind
; (normal_torus_vector.s).

        .kernel shade
normal_torus:
        load_shape 4
        MPYS    qx, qx, t0
        MPYS    qz, qz, t1
        MPYS    qy, qy, t2
        ADDN    t1, t0, t0
        MPYS    t2, sh0, t1
        ADDN    t1, t0, t0
        ADDN    t0, sh1, t0                     ; g
        MPYS    t0, qy, t1
        SUBN    t0, sh3, t0
        MPYS    t1, sh0, ny
        MPYS    t0, qx, nx
        MPYS    t0, qz, nz
        BIM     gradient_normal
        .endkernel
