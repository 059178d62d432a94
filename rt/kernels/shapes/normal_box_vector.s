; normal_box_vector.s - computes the normals of boxes (normal_vector.s).

        .kernel shade
; The face is the one with the nearest plane: the axis with the smallest
; | |X - C| - half edge |; x before y before z if two are equal.  Distances are
; compared and not ratios, because a box may be flat.
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
        .endkernel
