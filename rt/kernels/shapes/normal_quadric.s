; normal_quadric.s - computes the normal of a quadric (normal_vector.s).

        .kernel shade
; N = A (X - C) + g, normalised.
normal_quadric:
        load_shape 13
        three   lower, qx, qy, qz, sh0, sh1, sh2, t0, t1, t2
        matrix_times t0, t1, t2, nx, ny, nz
        three   raise, nx, ny, nz, sh9, sh10, sh11, nx, ny, nz
; Normalises a gradient.  A zero gradient, at an apex, becomes x.
gradient_normal:
        dot_product nx, ny, nz, nx, ny, nz, t0, t1
        if_equal_number t0, r0, gradient_there
        then_set m_one, t0
        then_set m_one, nx
        end_if  gradient_there
        root    t0, t0
        into    m_one, t0, t0
        three_by times, t0, nx, ny, nz, nx, ny, nz
        leave_normal
        .endkernel
