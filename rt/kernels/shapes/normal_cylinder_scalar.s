; normal_cylinder_scalar.s - computes the normal of a cylinder
; (normal_cylinder_vector.s).

        .kernel shade
        .macro  side_normal u, v, n
        MPYS    t0, \u, t3
        MPYS    t1, \v, t4
        ADDN    t4, t3, t3
        MPYS    t3, sh15, \n
        .endm

normal_cylinder:
        load_shape 16
        SUBN    qx, sh0, t3
        SUBN    qy, sh1, t4
        SUBN    qz, sh2, t5
        dot     t3, t4, t5, sh3, sh4, sh5, t0, t6
        dot     t3, t4, t5, sh6, sh7, sh8, t1, t6
        dot     t3, t4, t5, sh9, sh10, sh11, t2, t6
        MPYS    t0, t0, t3
        MPYS    t1, t1, t4
        ADDN    t4, t3, t3
        SUBN    t3, sh12, t3
        MPYS    t3, sh14, t3
        ABS     t3, t3
        ABS     t2, t4
        SUBN    t4, sh13, t4
        ABS     t4, t4
        CFPGE   t4, t3, normal_side
normal_end_disk:
        RTOR    sh9, nx
        RTOR    sh10, ny
        RTOR    sh11, nz
        CFPGE   t2, r0, normal_disk
        SUBN    r0, nx, nx
        SUBN    r0, ny, ny
        SUBN    r0, nz, nz
normal_disk:
        BIM     0, normal_link

normal_open_cylinder:
        load_shape 16
        SUBN    qx, sh0, t3
        SUBN    qy, sh1, t4
        SUBN    qz, sh2, t5
        dot     t3, t4, t5, sh3, sh4, sh5, t0, t6
        dot     t3, t4, t5, sh6, sh7, sh8, t1, t6
normal_side:
        side_normal sh3, sh6, nx
        side_normal sh4, sh7, ny
        side_normal sh5, sh8, nz
        BIM     0, normal_link
        .endkernel

        .ifdef  HISTORICAL
        .include "shapes/normal_cylinder_clipped_scalar.s"
        .endif
