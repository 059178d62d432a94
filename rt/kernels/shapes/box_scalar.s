; box_scalar.s - intersects one ray with a box with edges along the axes.
;
;       CALL BOX (RAY, PRIMITIVE, SEGMENT)
;
; The arguments are those of sphere_scalar.s, the method is that of
; box_vector.s.

        shape_from r52                  ; after t3
        .equ    BOX_REGISTERS, 26

        .data
box_save:       .space BOX_REGISTERS
        .code
        .kernel box
box:
        enter_kernel box_save, BOX_REGISTERS, 6
        RTOR    minus_big, tin
        RTOR    big, tout
        slab    ox, dx, sh0, sh3, box_miss
        slab    oy, dy, sh1, sh4, box_miss
        slab    oz, dz, sh2, sh5, box_miss
        leave_kernel
box_miss:
        RTOR    big, tin
        RTOR    minus_big, tout
        leave_kernel
        .endkernel
