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

        .share  local
        .regs   r96, hx0, hy0, hz0, hx1, hy1, hz1, hx2, hy2, hz2, hx3, hy3
        .regs   r107, hz3, hx4, hy4, hz4, hx5, hy5, hz5
        .regs   r114, hw0, hw1, hw2, hw3, hw4, hw5
        .regs   r120, here_s, here_t, here_s2, here_t2, here_x, here_y, here_z
        .regs   r127, v0, v1, v2, v3
        .endshare

; Three coordinates of a tangent: s2 = 2 s or 2 t, the other parameter.
        .macro  tangent x, y, z, xx, yy, zz, xy, yx, zx, twice, other, e0, e1, e2
        MPYS    \xx, \twice, \e0
        MPYS    \yy, \twice, \e1
        MPYS    \zz, \twice, \e2
        MPYS    \xy, \other, v0
        MPYS    \yx, \other, v1
        MPYS    \zx, \other, v2
        ADDN    \e0, \x, \e0
        ADDN    \e1, \y, \e1
        ADDN    \e2, \z, \e2
        ADDN    v0, \e0, \e0
        ADDN    v1, \e1, \e1
        ADDN    v2, \e2, \e2
        .endm

        .macro  less_weight w, e0, e1, e2
        MPYS    here_x, \w, v0
        MPYS    here_y, \w, v1
        MPYS    here_z, \w, v2
        SUBN    \e0, v0, \e0
        SUBN    \e1, v1, \e1
        SUBN    \e2, v2, \e2
        .endm

        .macro  tangents words
        get_field P_TABLE, here
        ELEN    here, \words
        SWAP    [here], hx0, [r0]
        get_record P_PATCH_POINT, 2, here_s
        ADDN    here_s, here_s, here_s2
        ADDN    here_t, here_t, here_t2
        tangent hx1, hy1, hz1, hx3, hy3, hz3, hx4, hy4, hz4, here_s2, here_t, t0, t1, t2
        tangent hx2, hy2, hz2, hx5, hy5, hz5, hx4, hy4, hz4, here_t2, here_s, t3, t4, t5
        .endm

normal_rational_steiner:
        load_shape 3
        tangents 24
        SUBN    qx, sh0, here_x
        SUBN    qy, sh1, here_y
        SUBN    qz, sh2, here_z
        MPYS    hw3, here_s2, t6
        MPYS    hw4, here_t, t7
        MPYS    hw5, here_t2, t8
        MPYS    hw4, here_s, t9
        ADDN    t6, hw1, t6
        ADDN    t8, hw2, t8
        ADDN    t7, t6, t6
        ADDN    t9, t8, t8
        less_weight t6, t0, t1, t2
        less_weight t8, t3, t4, t5
        BIM     normal_patch
normal_steiner:
        tangents 18
normal_patch:
        cross_product t0, t1, t2, t3, t4, t5, nx, ny, nz
        BIM     gradient_normal
        .endkernel
