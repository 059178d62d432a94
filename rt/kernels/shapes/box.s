; box.s - intersects rays with a box with edges along the axes.
;
; The segment inside is the intersection of three slabs (forms_vector.s).
;
;       CALL BOX (RAY, PRIMITIVE, SEGMENT)
;
; In:  ox oy oz dx dy dz; the primitive's record.
; Out: tin, tout; a miss is big, minus_big.
; Record: least corner 3, greatest 3, centre 3, half edge 3.
; Source: the slab method (Kay and Kajiya 1986 describe it in this form).

        shape_record box, 6, 52                 ; after t3
        .kernel box
box:
        enter_shape box
        ray_set minus_big, tin
        ray_set big, tout
        slab    ox, dx, sh0, sh3, box_missed
        slab    oy, dy, sh1, sh4, box_missed
        slab    oz, dz, sh2, sh5, box_missed
        close_segment
        leave_shape
        missed  box_missed
        .endkernel
