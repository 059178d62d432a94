; normal_quadric_scalar.s - computes the normal of a quadric
; (normal_quadric_vector.s).

        .kernel shade
normal_quadric:
        load_shape 13
        SUBN    qx, sh0, t0
        SUBN    qy, sh1, t1
        SUBN    qz, sh2, t2
        matrix_rows t0, t1, t2, nx, ny, nz, t3, t4, t5, t6
        ADDN    nx, sh9, nx
        ADDN    ny, sh10, ny
        ADDN    nz, sh11, nz
gradient_normal:
        dot     nx, ny, nz, nx, ny, nz, t0, t1
        CFPNE   t0, r0, gradient_there
        RTOR    m_one, t0
        RTOR    m_one, nx
gradient_there:
        SQRT    t0, t0
        DIVS    m_one, t0, t0
        MPYS    nx, t0, nx
        MPYS    ny, t0, ny
        MPYS    nz, t0, nz
        BIM     0, normal_link
        .endkernel
