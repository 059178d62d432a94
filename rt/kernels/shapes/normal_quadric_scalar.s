; normal_quadric_scalar.s - the normal of a cone, a quadric; see
; normal_quadric_vector.s.  Parts of the subroutine SHADE as in
; normal_scalar.s.

        .kernel shade
        .macro  cone_normal u, v, w, n
        MPYS    t0, \u, t3
        MPYS    t1, \v, t4
        MPYS    sh13, \w, t5
        ADDN    t4, t3, t3
        SUBN    t3, t5, \n
        .endm

; In the frame of the axis: t0 t1 t2; rho in t6.
        .macro  cone_frame
        load_shape 16
        SUBN    qx, sh0, t3
        SUBN    qy, sh1, t4
        SUBN    qz, sh2, t5
        dot     t3, t4, t5, sh3, sh4, sh5, t0, t6
        dot     t3, t4, t5, sh6, sh7, sh8, t1, t6
        dot     t3, t4, t5, sh9, sh10, sh11, t2, t6
        MPYS    t0, t0, t3
        MPYS    t1, t1, t4
        ADDN    t4, t3, t3
        SQRT    t3, t6
        .endm

normal_cone:
        cone_frame
        MPYS    t2, sh13, t3
        ADDN    t3, sh12, t3
        SUBN    t6, t3, t3
        MPYS    t3, sh15, t3
        ABS     t3, t3
        ABS     t2, t4
        SUBN    t4, sh14, t4
        ABS     t4, t4
        CFPLT   t4, t3, normal_end_disk
        BIM     normal_cone_side

normal_open_cone:
        cone_frame
normal_cone_side:
        CFPNE   t6, r0, normal_cone_off_axis
        RTOR    m_one, t6
        RTOR    m_one, t0
normal_cone_off_axis:
        DIVS    sh15, t6, t6
        MPYS    sh13, sh15, sh13
        MPYS    t0, t6, t0
        MPYS    t1, t6, t1
        cone_normal sh3, sh6, sh9, nx
        cone_normal sh4, sh7, sh10, ny
        cone_normal sh5, sh8, sh11, nz
        BIM     0, normal_link

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
