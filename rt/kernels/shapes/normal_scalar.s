; normal_scalar.s - the normal at one point of a primitive; see
; normal_vector.s.  Parts of the subroutine SHADE, which branches to them by
; normal_link: point in qx qy qz, normal in nx ny nz; uses t0-t6.

        .kernel shade
        .macro  load_shape number
        RTOR    a_primitive, t0
        IX      t0, 64 * P_SHAPE
        ELEN    t0, \number
        SWAP    [t0], sh0, [r0]
        .endm

normal_sphere:
        load_shape 5
        SUBN    qx, sh0, nx
        SUBN    qy, sh1, ny
        SUBN    qz, sh2, nz
        MPYS    nx, sh4, nx
        MPYS    ny, sh4, ny
        MPYS    nz, sh4, nz
        BIM     0, normal_link

normal_plane:
        load_shape 3
        RTOR    sh0, nx
        RTOR    sh1, ny
        RTOR    sh2, nz
        BIM     0, normal_link

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

        .macro  side_normal u, v, n
        MPYS    t0, \u, t3
        MPYS    t1, \v, t4
        ADDN    t4, t3, t3
        MPYS    t3, sh15, \n
        .endm

normal_cylinder:
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
        SUBN    t3, sh12, t3
        MPYS    t3, sh14, t3
        ABS     t3, t3
        ABS     t2, t4
        SUBN    t4, sh13, t4
        ABS     t4, t4
        CFPGE   t4, t3, normal_side
normal_end_disk:
        RTOR    sh9, nx
        RTOR    sh10, ny
        RTOR    sh11, nz
        CFPGE   t2, r0, normal_disk
        SUBN    r0, nx, nx
        SUBN    r0, ny, ny
        SUBN    r0, nz, nz
normal_disk:
        BIM     0, normal_link

normal_open_cylinder:
        load_shape 16
        SUBN    qx, sh0, t3
        SUBN    qy, sh1, t4
        SUBN    qz, sh2, t5
        dot     t3, t4, t5, sh3, sh4, sh5, t0, t6
        dot     t3, t4, t5, sh6, sh7, sh8, t1, t6
normal_side:
        side_normal sh3, sh6, nx
        side_normal sh4, sh7, ny
        side_normal sh5, sh8, nz
        BIM     0, normal_link
        .endkernel
