; normal_prism_vector.s - computes the normals of prisms (normal_vector.s).
;
; A point belongs to the nearest cap or edge, seen along y.  An edge goes from a
; corner P back to the previous one.  With its direction u, length l and outward
; normal n:
;
;   along = (X - P) . u    across = (X - P) . n
;   distance^2 = across^2 + max(along - l, 0)^2 + min(along, 0)^2

        .kernel shade

; [v0] = the smallest square of a distance so far.  Lowers it to that of the
; edge; hits0 = the points to which the edge is nearer.
        .macro  nearest_edge x, z, foot_x, foot_z, back_x, back_z, length, out_x, out_z
        SUBNV   [\x], \foot_x, [v1]
        SUBNV   [\z], \foot_z, [v2]
        MPYSV   [v1], \back_x, [v3]
        LINKV
        MPYSV   [v2], \back_z, [v4]
        ADDNV   [v4], [v3], [v3]
        MPYSV   [v1], \out_x, [v4]
        LINKV
        MPYSV   [v2], \out_z, [v5]
        ADDNV   [v5], [v4], [v4]
        MPYSV   [v4], [v4], [v4]
        SUBNV   [v3], \length, [v5]
        CMPLTV  r0, [v5], [hits0]
        MPYSV   [v5], [v5], [v5]
        ADDNV   [v4], [v5], [v4] ? [hits0]
        CMPLTV  [v3], r0, [hits0]
        MPYSV   [v3], [v3], [v3]
        ADDNV   [v4], [v3], [v4] ? [hits0]
        CMPLTV  [v4], [v0], [hits0]
        VTOV    [v4], [v0] ? [hits0]
        .endm

        .macro  take_edge
        nearest_edge qx, qz, sh3, sh4, sh6, sh7, sh8, sh9, sh10
        VTOV    sh9, [nx] ? [hits0]
        VTOV    r0, [ny] ? [hits0]
        VTOV    sh10, [nz] ? [hits0]
        .endm

; Sets the normals of the nearer of the caps at y = sh0 and y = sh1; [v0] = the
; square of its distance.
        .macro  nearest_cap
        SUBNV   [qy], sh0, [v0]
        SUBNV   [qy], sh1, [v1]
        MPYSV   [v0], [v0], [v0]
        MPYSV   [v1], [v1], [v1]
        VTOV    r0, [nx]
        VTOV    minus_one, [ny]
        CMPLTV  [v1], [v0], [hits0]
        VTOV    [v1], [v0] ? [hits0]
        VTOV    one, [ny] ? [hits0]
        .endm

normal_open_prism:
        load_record P_SHAPE, 3, sh0
        VTOV    big, [v0]
        VTOV    one, [nx]
        VTOV    r0, [ny]
        BIM     normal_prism_sides
normal_prism:
        load_record P_SHAPE, 3, sh0
        nearest_cap
normal_prism_sides:
        VTOV    r0, [nz]
        load_field P_TABLE, s1
normal_prism_row:
        ELEN    s1, PRISM_SIZE
        SWAP    [s1], sh3, [r0]
        IX      s1, 64 * PRISM_SIZE
        CFPNE   sh5, r0, normal_prism_next
        take_edge
normal_prism_next:
        SUBN    sh2, one, sh2
        CFPLT   r0, sh2, normal_prism_row
        BIM     0, link_kernel
        .endkernel
