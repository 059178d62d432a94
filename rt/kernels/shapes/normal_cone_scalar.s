; normal_cone_scalar.s - computes the normal of a cone (normal_cone_vector.s).

        .kernel shade
        .macro  cone_normal u, v, w, n
        MPYS    t0, \u, t3
        MPYS    t1, \v, t4
        MPYS    sh13, \w, t5
        ADDN    t4, t3, t3
        SUBN    t3, t5, \n
        .endm

; The point in the frame of the axis: t0, t1, t2; t6 = rho.
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
        .endkernel
