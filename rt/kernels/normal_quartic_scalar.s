; normal_quartic_scalar.s - the normal of a shape whose crossings the root
; solver finds; see normal_quartic_vector.s.  Parts of the subroutine SHADE as
; in normal_scalar.s.

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
        .if     \words >= 3
        gradient_row sh1
        gradient_term sh2
        gradient_group_row
        .endif
        .if     \words >= 6
        gradient_row sh3
        gradient_term sh4
        gradient_term sh5
        gradient_group_row
        .endif
        .if     \words >= 10
        gradient_row sh6
        gradient_term sh7
        gradient_term sh8
        gradient_term sh9
        gradient_group_row
        .endif
        .if     \words >= 15
        gradient_row sh10
        gradient_term sh11
        gradient_term sh12
        gradient_term sh13
        gradient_term sh14
        gradient_group_row
        .endif
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
        load_field P_TABLE, here
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
