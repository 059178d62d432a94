; normal_box_scalar.s - computes the normal of a box (normal_box_vector.s).

        .kernel shade
        .macro  face q, n
        RTOR    m_one, \n
        CFPGE   \q, r0, face_done\@
        RTOR    m_minus_one, \n
face_done\@:
        BIM     0, normal_link
        .endm

normal_box:
        load_shape 12
        SUBN    qx, sh6, t0
        SUBN    qy, sh7, t1
        SUBN    qz, sh8, t2
        RTOR    m_zero, nx
        RTOR    m_zero, ny
        RTOR    m_zero, nz
        ABS     t0, t3
        ABS     t1, t4
        ABS     t2, t5
        SUBN    t3, sh9, t3
        SUBN    t4, sh10, t4
        SUBN    t5, sh11, t5
        ABS     t3, t3
        ABS     t4, t4
        ABS     t5, t5
        CFPLT   t4, t3, normal_not_x
        CFPLT   t5, t3, normal_not_x
        face    t0, nx
normal_not_x:
        CFPLT   t5, t4, normal_box_z
        face    t1, ny
normal_box_z:
        face    t2, nz
        .endkernel
