; normal_cylinder_clipped_vector.s - computes the normals of cylinders that are
; intersected by cylinder_clipped_vector.s (normal_vector.s).
;
; A point belongs to the surface of the ray's entry or to that of its exit,
; whichever is nearer.  X is relative to the base and x = X - (X . A) A is its
; part across the axis:
;   side 0    | x . x - r^2 | / (2 r)         N = x / r
;   bottom 1  | p . X + q |                   N = p
;   top 2     the same with the other plane
; If no surface is recorded (CYLINDER_UNRECORDED), it is the nearest of the three.

        .kernel shade
        .macro  less_along x, a, n
        LINKV
        MPYSV   [v3], \a, [v4]
        SUBNV   [\x], [v4], [\n]
        .endm

; X - B in v0-v2; its part across the axis in nx, ny, nz.
        .macro  find_across
        load_record P_SHAPE, 16, sh0
        SUBNV   [qx], sh0, [v0]
        SUBNV   [qy], sh1, [v1]
        SUBNV   [qz], sh2, [v2]
        dot_constant v0, v1, v2, sh3, sh4, sh5, v3, v4
        less_along v0, sh3, nx
        less_along v1, sh4, ny
        less_along v2, sh5, nz
        .endm

        .macro  side_unit
        MPYSV   [nx], sh15, [nx]
        MPYSV   [ny], sh15, [ny]
        MPYSV   [nz], sh15, [nz]
        .endm

        .macro  from_plane p0, p1, p2, q, distance
        dot_constant qx, qy, qz, \p0, \p1, \p2, \distance, v7
        ADDNV   [\distance], \q, [\distance]
        .endm

        .ifdef  CYLINDER_UNRECORDED
; Changes the surface in cr to number in the lanes in which that is nearer, at
; distance.
        .macro  nearer distance, number
        CMPLTV  |[\distance]|, |[v2]|, [hits0]
        VTOV    [\distance], [v2] ? [hits0]
        VTOV    \number, [cr] ? [hits0]
        .endm

        .macro  find_recorded
        VTOV    r0, [cr]
        nearer  v0, one
        nearer  v1, two
        .endm
        .else
; Computes the distances of the points from the surface recorded in x.
        .macro  from_surface x, distance
        VTOV    [v2], [\distance]
        CMPEQV  [\x], one, [hits0]
        VTOV    [v0], [\distance] ? [hits0]
        CMPEQV  [\x], two, [hits0]
        VTOV    [v1], [\distance] ? [hits0]
        .endm

        .macro  find_recorded
        VXTOV   [at], [hit_s], [cr]
        VXTOV   [at], [hit_t], [cg]
        from_surface cr, v3
        from_surface cg, v4
        CMPLTV  |[v4]|, |[v3]|, [hits0]
        VTOV    [cg], [cr] ? [hits0]
        .endm
        .endif

        .macro  end_unit number, p0, p1, p2
        CMPEQV  [cr], \number, [hits0]
        VTOV    \p0, [nx] ? [hits0]
        VTOV    \p1, [ny] ? [hits0]
        VTOV    \p2, [nz] ? [hits0]
        .endm

normal_clipped_cylinder:
        find_across
        dot_vectors nx, ny, nz, nx, ny, nz, v2, v3
        MPYS    sh6, sh6, s0
        MPYS    sh15, half, s1
        LINKV
        SUBNV   [v2], s0, [v2]
        MPYSV   [v2], s1, [v2]
        side_unit
        from_plane sh7, sh8, sh9, sh10, v0
        from_plane sh11, sh12, sh13, sh14, v1
        find_recorded
        end_unit one, sh7, sh8, sh9
        end_unit two, sh11, sh12, sh13
        BIM     0, link_kernel

normal_open_clipped_cylinder:
        find_across
        side_unit
        BIM     0, link_kernel
        .endkernel
