; normal_quadric.s - computes the normal of a quadric (normal_vector.s).

        .kernel shade
; N = A (X - C) + g, normalised.
normal_quadric:
        load_shape 13
        lower   qx, sh0, t0
        lower   qy, sh1, t1
        lower   qz, sh2, t2
        matrix_times t0, t1, t2, nx, ny, nz
        raise   nx, sh9, nx
        raise   ny, sh10, ny
        raise   nz, sh11, nz
; Normalises a gradient.  A zero gradient, at an apex, becomes x.
gradient_normal:
        dot_product nx, ny, nz, nx, ny, nz, t0, t1
        if_equal_number t0, r0, gradient_there
        then_set m_one, t0
        then_set m_one, nx
        end_if  gradient_there
        root    t0, t0
        into    m_one, t0, t0
        times   nx, t0, nx
        times   ny, t0, ny
        times   nz, t0, nz
        leave_normal
        .endkernel
