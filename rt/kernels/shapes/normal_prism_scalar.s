; normal_prism_scalar.s - the normal of a prism; see normal_prism_vector.s.

        .kernel shade
normal_open_prism:
        load_shape 3
        EX      t0, k_big
        LOD     [t0], t0                        ; the least square so far
        RTOR    m_one, nx
        RTOR    m_zero, ny
        BIM     normal_prism_sides
normal_prism:
        load_shape 3
        SUBN    qy, sh0, t0
        SUBN    qy, sh1, t1
        MPYS    t0, t0, t0
        MPYS    t1, t1, t1
        RTOR    m_zero, nx
        RTOR    m_minus_one, ny
        CFPGE   t1, t0, normal_prism_sides
        RTOR    t1, t0
        RTOR    m_one, ny
normal_prism_sides:
        RTOR    m_zero, nz
        get_field P_TABLE, here
normal_prism_row:
        ELEN    here, PRISM_SIZE
        SWAP    [here], sh3, [r0]
        IX      here, 64 * PRISM_SIZE
        CFPNE   sh5, r0, normal_prism_next
        SUBN    qx, sh3, t1
        SUBN    qz, sh4, t2
        MPYS    t1, sh6, t3
        MPYS    t2, sh7, t4
        MPYS    t1, sh9, t5
        MPYS    t2, sh10, t6
        ADDN    t4, t3, t3                      ; along
        ADDN    t6, t5, t4
        MPYS    t4, t4, t4                      ; across, its square
        SUBN    t3, sh8, t5
        CFPGE   r0, t5, normal_prism_begins
        MPYS    t5, t5, t5
        ADDN    t4, t5, t4
normal_prism_begins:
        CFPGE   t3, r0, normal_prism_square
        MPYS    t3, t3, t3
        ADDN    t4, t3, t4
normal_prism_square:
        CFPGE   t4, t0, normal_prism_next
        RTOR    t4, t0
        RTOR    sh9, nx
        RTOR    m_zero, ny
        RTOR    sh10, nz
normal_prism_next:
        SUBN    sh2, m_one, sh2
        CFPLT   r0, sh2, normal_prism_row
        BIM     0, normal_link
        .endkernel
