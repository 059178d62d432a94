; normal_cylinder_vector.s - computes the normals of cylinders
; (normal_vector.s).

        .kernel shade
; In the frame u, v, w of the cylinder's axis X - C = (xu, xv, xw).  A point
; belongs to a disk if it is nearer to the disk's plane than to the side:
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

; Sets the normal of a disk in the lanes in which [v1], the distance to the
; disk, is less than [v0], the distance to the side.
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
        ADDNV   [v1], [v0], [v3]
        LINKV
        SUBNV   [v3], sh12, [v0]
        MPYSV   [v0], sh14, [v0]
        SUBNV   |[v2]|, sh13, [v1]
        end_disk_normal
        BIM     0, link_kernel

normal_open_cylinder:
        cylinder_side_normal
        BIM     0, link_kernel
        .endkernel

        .ifdef  HISTORICAL
        .include "shapes/normal_cylinder_clipped_vector.s"
        .endif
