; normal_quadratic_prism_scalar.s - computes the normal of a prism of quadratic
; splines (normal_quadratic_prism_vector.s).

        .if     QUADRATIC_PRISMS
        .kernel shade
        .share  local
        .regs   r96, foot_x, foot_z, bow_x, bow_z, path_x, path_z, share_x, share_z
        .regs   r104, curve_outward, curve_w, slope_x, slope_z
        .endshare

normal_open_quadratic_prism:
        load_shape 3
        EX      t0, k_big
        LOD     [t0], t0                        ; the smallest square so far
        RTOR    m_one, nx
        RTOR    m_zero, ny
        BIM     normal_curves
normal_quadratic_prism:
        load_shape 3
        nearest_cap
normal_curves:
        RTOR    m_zero, nz
        get_field P_TABLE, here
normal_curve:
        RTOR    here, t1
        IX      t1, 64 * QUADRATIC_BEGINS
        LOD     [t1], t2
        CFPNE   t2, r0, normal_curve_next
        IX      t1, 64 * (QUADRATIC_FOOT - QUADRATIC_BEGINS)
        ELEN    t1, 9
        SWAP    [t1], foot_x, [r0]              ; foot_x .. curve_outward
        SUBN    qx, foot_x, t1
        SUBN    qz, foot_z, t2
        MPYS    t1, share_x, t3
        MPYS    t2, share_z, t4
        ADDN    t4, t3, curve_w
        CFPGE   curve_w, r0, normal_curve_above
        RTOR    m_zero, curve_w
normal_curve_above:
        CFPGE   m_one, curve_w, normal_curve_below
        RTOR    m_one, curve_w
normal_curve_below:
        MPYS    curve_w, bow_x, t5
        MPYS    curve_w, bow_z, t6
        ADDN    t5, path_x, slope_x
        ADDN    t6, path_z, slope_z
        MPYS    slope_x, curve_w, t3
        MPYS    slope_z, curve_w, t4
        SUBN    t1, t3, t1
        SUBN    t2, t4, t2
        MPYS    t1, t1, t1
        MPYS    t2, t2, t2
        ADDN    t2, t1, t1
        CFPGE   t1, t0, normal_curve_next
        RTOR    t1, t0
        ADDN    t6, slope_z, t6
        ADDN    t5, slope_x, t5
        MPYS    t6, curve_outward, nx
        RTOR    m_zero, ny
        SUBN    m_zero, curve_outward, t4
        MPYS    t5, t4, nz
normal_curve_next:
        IX      here, 64 * QUADRATIC_SIZE
        SUBN    sh2, m_one, sh2
        CFPLT   r0, sh2, normal_curve
        BIM     gradient_normal
        .endkernel
        .endif
