; normal_steiner_patch_scalar.s - computes the normal of a Steiner patch
; (normal_steiner_patch_vector.s).

        .kernel shade
        .share  local
        .regs   r96, hx0, hy0, hz0, hx1, hy1, hz1, hx2, hy2, hz2, hx3, hy3
        .regs   r107, hz3, hx4, hy4, hz4, hx5, hy5, hz5
        .regs   r114, hw0, hw1, hw2, hw3, hw4, hw5
        .regs   r120, here_s, here_t, here_s2, here_t2, here_x, here_y, here_z
        .regs   r127, v0, v1, v2, v3
        .endshare

; Computes the coordinates of a tangent; twice = 2 s or 2 t, other = the other
; parameter.
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
