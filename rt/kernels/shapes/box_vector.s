; box_vector.s - intersects a queue of rays with a box with edges along the
; axes.
;
; The segment inside is the intersection of three slabs (slab_vector.s).
;
; In:  ox oy oz dx dy dz, n long; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Source: the slab method (Kay and Kajiya 1986 describe it in this form).

        .kernel box
box:
        load_record P_SHAPE, 6, sh0
        VTOV    minus_big, [tin]
        VTOV    big, [tout]
        slab    ox, dx, sh0, sh3
        slab    oy, dy, sh1, sh4
        slab    oz, dz, sh2, sh5
        close_segment
        BIM     0, link_kernel
        .endkernel
