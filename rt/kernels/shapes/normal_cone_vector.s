; normal_cone_vector.s - computes the normals of cones (normal_vector.s).

        .kernel shade
; In the frame u, v, w of the cone's axis X - C = (xu, xv, xw).  With
; rho = sqrt(xu^2 + xv^2), r = r0 + k xw, g = 1/sqrt(1 + k^2), a point belongs
; to a disk if it is nearer to the disk's plane than to the side:
;   | |xw| - half | < |rho - r| g
; Disk: N = w with the sign of xw.  Side: N = g (xu/rho u + xv/rho v - k w).
; At the apex, rho = 0, u replaces the quotients.
        .macro  cone_normal u, v, w, n
        MPYSV   [v3], \u, [v5]
        LINKV
        MPYSV   [v4], \v, [v6]
        ADDNV   [v6], [v5], [v5]
        MPYS    s1, \w, s2
        SUBNV   [v5], s2, [\n]
        .endm

        .macro  cone_side_normal
        load_record P_SHAPE, 16, sh0
        SUBNV   [qx], sh0, [v3]
        SUBNV   [qy], sh1, [v4]
        SUBNV   [qz], sh2, [v5]
        dot_constant v3, v4, v5, sh3, sh4, sh5, v0, v6
        dot_constant v3, v4, v5, sh6, sh7, sh8, v1, v6
        dot_constant v3, v4, v5, sh9, sh10, sh11, v2, v6
        MPYSV   [v0], [v0], [v3]
        MPYSV   [v1], [v1], [v4]
        ADDNV   [v4], [v3], [v3]
        SQRTV   [v3], [v7]                      ; rho
        CMPEQV  [v7], r0, [hits3]
        MASKV   one, [v7], [v4] ? [hits3]
        VTOV    one, [v0] ? [hits3]
        DIVSV   sh15, [v4], [v5]                ; g / rho
        MPYSV   [v0], [v5], [v3]
        MPYSV   [v1], [v5], [v4]
        MPYS    sh13, sh15, s1                  ; k g
        cone_normal sh3, sh6, sh9, nx
        cone_normal sh4, sh7, sh10, ny
        cone_normal sh5, sh8, sh11, nz
        .endm

normal_cone:
        cone_side_normal
        LINKV
        MPYSV   [v2], sh13, [v0]
        ADDNV   [v0], sh12, [v0]
        LINKV
        SUBNV   [v7], [v0], [v0]
        MPYSV   [v0], sh15, [v0]
        SUBNV   |[v2]|, sh14, [v1]
        end_disk_normal
        BIM     0, link_kernel

normal_open_cone:
        cone_side_normal
        BIM     0, link_kernel
        .endkernel
