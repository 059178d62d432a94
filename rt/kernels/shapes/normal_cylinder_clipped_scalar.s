; normal_cylinder_clipped_scalar.s - computes the normal of a cylinder that is
; intersected by cylinder_clipped_scalar.s (normal_cylinder_clipped_vector.s).

        .kernel shade
        .share  local
        .regs   r96, recorded_in, recorded_out
        .endshare

        .macro  find_across
        load_shape 16
        SUBN    qx, sh0, t0
        SUBN    qy, sh1, t1
        SUBN    qz, sh2, t2
        dot     t0, t1, t2, sh3, sh4, sh5, t3, t4
        MPYS    t3, sh3, t4
        MPYS    t3, sh4, t5
        MPYS    t3, sh5, t6
        SUBN    t0, t4, nx
        SUBN    t1, t5, ny
        SUBN    t2, t6, nz
        .endm

        .macro  from_plane p0, p1, p2, q, distance
        dot     qx, qy, qz, \p0, \p1, \p2, \distance, t4
        ADDN    \distance, \q, \distance
        .endm

        .ifdef  CYLINDER_UNRECORDED
        .macro  nearer distance, number
        ABS     \distance, \distance
        CFPGE   \distance, t2, nearer_not\@
        RTOR    \distance, t2
        RTOR    \number, recorded_in
nearer_not\@:
        .endm

        .macro  find_recorded
        ABS     t2, t2
        RTOR    r0, recorded_in
        nearer  t0, m_one
        nearer  t1, m_two
        .endm
        .else
        .macro  from_surface x, distance
        RTOR    t2, \distance
        CFPEQ   \x, r0, from_side\@
        RTOR    t0, \distance
        CFPEQ   \x, m_one, from_side\@
        RTOR    t1, \distance
from_side\@:
        ABS     \distance, \distance
        .endm

        .macro  find_recorded
        get_record P_PATCH_POINT, 2, recorded_in
        from_surface recorded_in, t3
        from_surface recorded_out, t4
        CFPGE   t4, t3, recorded_nearer\@
        RTOR    recorded_out, recorded_in
recorded_nearer\@:
        .endm
        .endif

normal_clipped_cylinder:
        find_across
        dot     nx, ny, nz, nx, ny, nz, t2, t3
        MPYS    sh6, sh6, t3
        MPYS    sh15, m_half, t4
        SUBN    t2, t3, t2
        MPYS    t2, t4, t2
        from_plane sh7, sh8, sh9, sh10, t0
        from_plane sh11, sh12, sh13, sh14, t1
        find_recorded
        CFPEQ   recorded_in, r0, clipped_side
        RTOR    sh7, nx
        RTOR    sh8, ny
        RTOR    sh9, nz
        CFPEQ   recorded_in, m_one, clipped_found
        RTOR    sh11, nx
        RTOR    sh12, ny
        RTOR    sh13, nz
        BIM     0, normal_link

normal_open_clipped_cylinder:
        find_across
clipped_side:
        MPYS    nx, sh15, nx
        MPYS    ny, sh15, ny
        MPYS    nz, sh15, nz
clipped_found:
        BIM     0, normal_link
        .endkernel
