; normal_vector.s - the normals at m points of one primitive.
;
; In:  [qx] [qy] [qz], the points in the shape's own space; the record.
; Out: [nx] [ny] [nz], in that space, of length one, pointing outwards.
; Source: textbook; which face or side is decided by the least distance.
; Uses v0-v7, hits0-hits3.

        .share  phase
        .regs   r185, qx, qy, qz            ; point
        .endshare

        .macro  look_at_points x0, x1, x2
        RTOR    \x0, qx
        RTOR    \x1, qy
        RTOR    \x2, qz
        .endm

        .kernel shade

; Sphere: N = (X - C) / r.
normal_sphere:
        load_record P_SHAPE, 5, sh0
        LINKV
        SUBNV   [qx], sh0, [nx]
        MPYSV   [nx], sh4, [nx]
        LINKV
        SUBNV   [qy], sh1, [ny]
        MPYSV   [ny], sh4, [ny]
        LINKV
        SUBNV   [qz], sh2, [nz]
        MPYSV   [nz], sh4, [nz]
        BIM     0, link_kernel

; Plane: its own.
normal_plane:
        load_record P_SHAPE, 3, sh0
        VTOV    sh0, [nx]
        VTOV    sh1, [ny]
        VTOV    sh2, [nz]
        BIM     0, link_kernel

; Box: the face is the one whose plane is nearest,  | |X - C| - half edge |
; the least of the three axes; x before y before z where two are equal.
; Distances, not the ratio of the two: a box may be flat.
        .macro  face q, n, bits
        CMPGEV  [\q], r0, [hits2]
        MASKV   one, minus_one, [v6] ? [hits2]
        VTOV    r0, [\n]
        VTOV    [v6], [\n] ? [\bits]
        .endm

normal_box:
        load_record P_SHAPE, 12, sh0
        SUBNV   [qx], sh6, [v0]
        SUBNV   [qy], sh7, [v1]
        SUBNV   [qz], sh8, [v2]
        SUBNV   |[v0]|, sh9, [v3]
        SUBNV   |[v1]|, sh10, [v4]
        SUBNV   |[v2]|, sh11, [v5]
        CMPGEV  |[v4]|, |[v3]|, [hits0]
        CMPGEV  |[v5]|, |[v3]|, [hits1]
        ANDB    [hits0], [hits1], [hits0]       ; x
        face    v0, nx, hits0
        CMPGEV  |[v5]|, |[v4]|, [hits1]
        ANDNB   [hits1], [hits0], [hits3]       ; y, not x
        face    v1, ny, hits3
        NORB    [hits0], [hits1], [hits3]       ; neither
        face    v2, nz, hits3
        BIM     0, link_kernel

; Cylinder, in the frame u v w of its axis, X - C = (xu, xv, xw): a point
; belongs to a disk if it is nearer to the disk's plane than to the side,
;   | |xw| - half | < |(xu^2 + xv^2 - r^2) / (2 r)|
; Disk: N = w with the sign of xw.  Side: N = (xu u + xv v) / r.
        .macro  side_normal u, v, n
        MPYSV   [v0], \u, [v3]
        LINKV
        MPYSV   [v1], \v, [v4]
        ADDNV   [v4], [v3], [v3]
        MPYSV   [v3], sh15, [\n]
        .endm

        .macro  cylinder_side_normal
        load_record P_SHAPE, 16, sh0
        SUBNV   [qx], sh0, [v3]
        SUBNV   [qy], sh1, [v4]
        SUBNV   [qz], sh2, [v5]
        dot_constant v3, v4, v5, sh3, sh4, sh5, v0, v6
        dot_constant v3, v4, v5, sh6, sh7, sh8, v1, v6
        dot_constant v3, v4, v5, sh9, sh10, sh11, v2, v6
        side_normal sh3, sh6, nx
        side_normal sh4, sh7, ny
        side_normal sh5, sh8, nz
        .endm

        .macro  disk_normal w, n
        VTOV    \w, [\n] ? [hits0]
        VTOV    -\w, [\n] ? [hits1]
        .endm

; Where [v1], the distance to a disk, is less than [v0], that to the side.
        .macro  end_disk_normal
        CMPLTV  |[v1]|, |[v0]|, [hits0]
        CMPLTV  [v2], r0, [hits2]
        ANDB    [hits0], [hits2], [hits1]
        disk_normal sh9, nx
        disk_normal sh10, ny
        disk_normal sh11, nz
        .endm

normal_cylinder:
        cylinder_side_normal
        MPYSV   [v0], [v0], [v0]
        MPYSV   [v1], [v1], [v1]
        LINKV
        ADDNV   [v1], [v0], [v3]
        SUBNV   [v3], sh12, [v0]
        MPYSV   [v0], sh14, [v0]
        SUBNV   |[v2]|, sh13, [v1]
        end_disk_normal
        BIM     0, link_kernel

normal_open_cylinder:
        cylinder_side_normal
        BIM     0, link_kernel
        .endkernel
