; box_scalar.s - one ray meets a box with edges along the axes.
;
;       CALL BOX (RAY, PRIMITIVE, SEGMENT)
;
; Arguments as in sphere_scalar.s, method as in box_vector.s.

        .data
box_save:       .space 32
        .code
        .kernel box
box:
        enter_kernel box_save, 32, 6
        RTOR    minus_big, tin
        RTOR    big, tout
        slab    ox, dx, sh0, sh3, box_miss
        slab    oy, dy, sh1, sh4, box_miss
        slab    oz, dz, sh2, sh5, box_miss
        leave_kernel box_save, 32
box_miss:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel box_save, 32
        .endkernel
