; normal_blob_scalar.s - computes the normal of a blob (normal_blob_vector.s).

        .kernel shade
        .if     BLOB_PIECES
normal_blob:
        load_shape 6
        SUBN    qx, sh0, qx
        SUBN    qy, sh1, qy
        SUBN    qz, sh2, qz
        RTOR    sh5, t6
        ADDN    m_zero, m_zero, nx
        ADDN    m_zero, m_zero, ny
        ADDN    m_zero, m_zero, nz
        get_field P_TABLE, here
        IX      here, 64 * BLOB_STRENGTH
normal_blob_row:
        ELEN    here, 14
        SWAP    [here], sh0, [r0]
        IX      here, 64 * BLOB_SIZE
        dot     qx, qy, qz, sh2, sh3, sh4, t0, t3
        dot     qx, qy, qz, sh6, sh7, sh8, t1, t4
        dot     qx, qy, qz, sh10, sh11, sh12, t2, t5
        ADDN    t0, sh5, t0
        ADDN    t1, sh9, t1
        ADDN    t2, sh13, t2
        CFPLT   t2, r0, normal_blob_end
        SUBN    t2, sh1, t2
        CFPGE   t2, r0, normal_blob_end
        ADDN    m_zero, m_zero, t2
normal_blob_end:
        dot     t0, t1, t2, t0, t1, t2, t3, t4
        SUBN    m_one, t3, t3
        CFPGE   r0, t3, normal_blob_next
        MPYS    t3, sh0, t3
        MPYS    t0, t3, t0
        MPYS    t1, t3, t1
        MPYS    t2, t3, t2
        dot     t0, t1, t2, sh2, sh6, sh10, t3, t4
        ADDN    nx, t3, nx
        dot     t0, t1, t2, sh3, sh7, sh11, t3, t4
        ADDN    ny, t3, ny
        dot     t0, t1, t2, sh4, sh8, sh12, t3, t4
        ADDN    nz, t3, nz
normal_blob_next:
        SUBN    t6, m_one, t6
        CFPLT   r0, t6, normal_blob_row
        BIM     gradient_normal
        .endif
        .endkernel
