; normal_lathe_scalar.s - computes the normal of a lathe
; (normal_lathe_vector.s).

        .if     LATHES
        .kernel shade
        .share  local
        .regs   r96, from_axis_here, height_here, foot_height, foot_begins
        .regs   r100, foot_low, foot_high, foot_radius, back_r, back_y
        .regs   r105, back_length, outward_r, outward_y, rows_here
        .regs   r109, height_less, height_more
        .endshare

normal_lathe:
        load_shape 7
        RTOR    sh3, rows_here
        MPYS    qx, qx, t0
        MPYS    qz, qz, t1
        SUBN    qy, sh0, height_here
        ADDN    t1, t0, t0
        SQRT    t0, from_axis_here
        RTOR    sh5, t0                         ; the smallest square so far
        SUBN    height_here, sh6, height_less
        ADDN    height_here, sh6, height_more
        RTOR    m_one, nx
        RTOR    m_zero, ny
        get_field P_TABLE, here
        IX      here, 64 * LATHE_HEIGHT
normal_lathe_row:
        ELEN    here, 4
        SWAP    [here], foot_height, [r0]       ; foot_height .. foot_high
        CFPNE   foot_begins, r0, normal_lathe_next
        CFPLT   foot_high, height_less, normal_lathe_next
        CFPLT   height_more, foot_low, normal_lathe_next
        RTOR    here, t1
        IX      t1, 64 * (LATHE_RADIUS - LATHE_HEIGHT)
        ELEN    t1, 6
        SWAP    [t1], foot_radius, [r0]         ; foot_radius .. outward_y
        nearest_edge from_axis_here, height_here, foot_radius, foot_height, back_r, back_y, back_length, outward_r, outward_y, normal_lathe_next
        RTOR    outward_r, nx
        RTOR    outward_y, ny
normal_lathe_next:
        IX      here, 64 * LATHE_SIZE
        SUBN    rows_here, m_one, rows_here
        CFPLT   r0, rows_here, normal_lathe_row
        RTOR    qx, t1
        CFPNE   from_axis_here, r0, normal_lathe_off_axis
        RTOR    m_one, from_axis_here
        RTOR    m_one, t1
normal_lathe_off_axis:
        DIVS    nx, from_axis_here, t2
        MPYS    t1, t2, nx
        MPYS    qz, t2, nz
        BIM     0, normal_link
        .endkernel
        .endif
