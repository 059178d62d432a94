; normal_prism_scalar.s - computes the normal of a prism
; (normal_prism_vector.s).

        .kernel shade

; t0 = the smallest square of a distance so far.  Lowers t0 to that of the edge,
; or branches to farther if the edge is not nearer.
        .macro  nearest_edge x, z, foot_x, foot_z, back_x, back_z, length, out_x, out_z, farther
        SUBN    \x, \foot_x, t1
        SUBN    \z, \foot_z, t2
        MPYS    t1, \back_x, t3
        MPYS    t2, \back_z, t4
        MPYS    t1, \out_x, t5
        MPYS    t2, \out_z, t6
        ADDN    t4, t3, t3                      ; along
        ADDN    t6, t5, t4
        MPYS    t4, t4, t4                      ; the square of across
        SUBN    t3, \length, t5
        CFPGE   r0, t5, edge_begins\@
        MPYS    t5, t5, t5
        ADDN    t4, t5, t4
edge_begins\@:
        CFPGE   t3, r0, edge_square\@
        MPYS    t3, t3, t3
        ADDN    t4, t3, t4
edge_square\@:
        CFPGE   t4, t0, \farther
        RTOR    t4, t0
        .endm

; Sets the normal of the nearer of the caps at y = sh0 and y = sh1; t0 = the
; square of its distance.
        .macro  nearest_cap
        SUBN    qy, sh0, t0
        SUBN    qy, sh1, t1
        MPYS    t0, t0, t0
        MPYS    t1, t1, t1
        RTOR    m_zero, nx
        RTOR    m_minus_one, ny
        CFPGE   t1, t0, cap_nearest\@
        RTOR    t1, t0
        RTOR    m_one, ny
cap_nearest\@:
        .endm

normal_open_prism:
        load_shape 3
        EX      t0, k_big
        LOD     [t0], t0                        ; the smallest square so far
        RTOR    m_one, nx
        RTOR    m_zero, ny
        BIM     normal_prism_sides
normal_prism:
        load_shape 3
        nearest_cap
normal_prism_sides:
        RTOR    m_zero, nz
        get_field P_TABLE, here
normal_prism_row:
        ELEN    here, PRISM_SIZE
        SWAP    [here], sh3, [r0]
        IX      here, 64 * PRISM_SIZE
        CFPNE   sh5, r0, normal_prism_next
        nearest_edge qx, qz, sh3, sh4, sh6, sh7, sh8, sh9, sh10, normal_prism_next
        RTOR    sh9, nx
        RTOR    m_zero, ny
        RTOR    sh10, nz
normal_prism_next:
        SUBN    sh2, m_one, sh2
        CFPLT   r0, sh2, normal_prism_row
        BIM     0, normal_link
        .endkernel
