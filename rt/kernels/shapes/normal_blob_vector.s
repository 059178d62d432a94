; normal_blob_vector.s - computes the normals of blobs (normal_vector.s).
;
; The normal is opposite to the gradient of the field.  The matrix M leads to
; the space of a component.  There P is relative to the nearest point of its
; axis, if it has one:
;
;   g = 1 - P . P        S g^2 falls fastest along  S g M^T P,   if g > 0

        .kernel shade
        .if     BLOB_PIECES
        .macro  part_point x, m0, m1, m2, m3, work
        dot_constant v0, v1, v2, \m0, \m1, \m2, \x, \work
        ADDNV   [\x], \m3, [\x]
        .endm

; Adds a component's part: strength sh0, length of the axis sh1, matrix
; sh2-sh13.
        .macro  take_part
        part_point v3, sh2, sh3, sh4, sh5, v6
        part_point v4, sh6, sh7, sh8, sh9, v6
        part_point v5, sh10, sh11, sh12, sh13, v6
        CMPLTV  [v5], r0, [hits0]
        VTOV    [v5], [v6]
        SUBNV   [v5], sh1, [v5]
        CMPLTV  [v5], r0, [hits1]
        VTOV    r0, [v5] ? [hits1]
        VTOV    [v6], [v5] ? [hits0]
        dot_vectors v3, v4, v5, v3, v4, v5, v6, v7
        SUBNV   one, [v6], [v6]
        CMPLTV  r0, [v6], [hits0]
        MPYSV   [v6], sh0, [v6]
        MPYSV   [v3], [v6], [v3]
        MPYSV   [v4], [v6], [v4]
        MPYSV   [v5], [v6], [v5]
        dot_constant v3, v4, v5, sh2, sh6, sh10, v6, v7
        ADDNV   [nx], [v6], [nx] ? [hits0]
        dot_constant v3, v4, v5, sh3, sh7, sh11, v6, v7
        ADDNV   [ny], [v6], [ny] ? [hits0]
        dot_constant v3, v4, v5, sh4, sh8, sh12, v6, v7
        ADDNV   [nz], [v6], [nz] ? [hits0]
        .endm

normal_blob:
        load_record P_SHAPE, 6, sh0
        SUBNV   [qx], sh0, [v0]
        SUBNV   [qy], sh1, [v1]
        SUBNV   [qz], sh2, [v2]
        RTOR    sh5, s2
        VTOV    r0, [nx]
        VTOV    r0, [ny]
        VTOV    r0, [nz]
        load_field P_TABLE, s1
        IX      s1, 64 * BLOB_STRENGTH
normal_blob_row:
        ELEN    s1, 14
        SWAP    [s1], sh0, [r0]
        IX      s1, 64 * BLOB_SIZE
        take_part
        SUBN    s2, one, s2
        CFPLT   r0, s2, normal_blob_row
        BIM     gradient_normal
        .endif
        .endkernel
