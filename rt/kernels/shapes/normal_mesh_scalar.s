; normal_mesh_scalar.s - computes the normal of a mesh (normal_mesh_vector.s).

        .kernel shade
        .share  local
        .regs   r96, corner_x, corner_y, corner_z
        .regs   r99, change_x, change_y, change_z
        .regs   r102, change_xx, change_xy, change_xz, change_yx, change_yy
        .regs   r107, change_yz, change_zx, change_zy, change_zz
        .endshare

        .macro  find_triangle
        get_field P_PATCH_POINT, here
        SHIFTI  here, 6, t0
        get_field P_TABLE, here
        ADDX    here, t0, here
        .endm

normal_mesh:
        find_triangle
        IX      here, 64 * TRIANGLE_NORMAL
        ELEN    here, 3
        SWAP    [here], nx, [r0]
        BIM     0, normal_link

normal_smooth_mesh:
        find_triangle
        RTOR    here, t0
        ELEN    t0, 3
        SWAP    [t0], corner_x, [r0]
        IX      here, 64 * TRIANGLE_NORMAL
        ELEN    here, 12
        SWAP    [here], change_x, [r0]
        SUBN    qx, corner_x, t0
        SUBN    qy, corner_y, t1
        SUBN    qz, corner_z, t2
        dot     t0, t1, t2, change_xx, change_xy, change_xz, t3, t6
        dot     t0, t1, t2, change_yx, change_yy, change_yz, t4, t6
        dot     t0, t1, t2, change_zx, change_zy, change_zz, t5, t6
        ADDN    t3, change_x, nx
        ADDN    t4, change_y, ny
        ADDN    t5, change_z, nz
        BIM     gradient_normal
        .endkernel
