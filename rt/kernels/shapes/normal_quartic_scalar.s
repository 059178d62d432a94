; normal_quartic_scalar.s - computes the normal of a quartic surface
; (normal_quartic_vector.s).

        .kernel shade
        .macro  gradient_step c, x, work
        MPYS    \c, \x, \c
        ADDN    \work, \c, \c
        .endm

        .macro  gradient_term c
        MPYS    t1, qz, t1
        MPYS    t0, qz, t6
        ADDN    t0, t1, t1
        ADDN    t6, \c, t0
        .endm

        .macro  gradient_row first
        RTOR    \first, t0
        RTOR    m_zero, t1
        .endm

        .macro  gradient_group_row
        MPYS    t3, qy, t3
        MPYS    t2, qy, t6
        MPYS    t4, qy, t4
        ADDN    t2, t3, t3
        ADDN    t0, t6, t2
        ADDN    t1, t4, t4
        .endm

        .macro  gradient_group words
        ELEN    here, \words
        SWAP    [here], sh0, [r0]
        IX      here, 64 * \words
        RTOR    sh0, t2
        RTOR    m_zero, t3
        RTOR    m_zero, t4
        gradient_rows \words
        MPYS    nx, qx, nx
        MPYS    t5, qx, t6
        MPYS    ny, qx, ny
        MPYS    nz, qx, nz
        ADDN    t5, nx, nx
        ADDN    t2, t6, t5
        ADDN    t3, ny, ny
        ADDN    t4, nz, nz
        .endm

normal_quartic:
        get_field P_TABLE, here
        RTOR    m_zero, nx
        RTOR    m_zero, ny
        RTOR    m_zero, nz
        RTOR    m_zero, t5
        gradient_group 1
        gradient_group 3
        gradient_group 6
        gradient_group 10
        gradient_group 15
        BIM     gradient_normal
        .endkernel
