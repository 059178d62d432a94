; transform_scalar.s - a primitive that stands in a space of its own.
;
;       CALL TRANSFORMED (RAY, PRIMITIVE, SEGMENT)
;
; Arguments as in sphere_scalar.s, method as in transform_vector.s.  The ray is
; carried over into own_ray, with its least distance, and the primitive's
; kernel called with it.

        .regs   r80, own_ox, own_oy, own_oz, own_dx, own_dy, own_dz
        .regs   r86, own_lower, own_scale, link_saved
        .equ    TRANSFORM_REGISTERS, KERNEL_REGISTERS_MOST

        .data
transform_save: .space TRANSFORM_REGISTERS
own_ray:        .space 7
own_segment:    .space 2
own_arguments:
        .descriptor 6, own_ray
own_primitive:
        .word 0
        .descriptor 2, own_segment

        .code
        .kernel transform
transformed:
        enter   kernel_image, transform_save, TRANSFORM_REGISTERS
        ELEN    arguments, 3
        SWAP    [arguments], a_ray, [r0]
        SWAP    [a_ray], ox, [r0]
        RTOR    a_primitive, t0
        IX      t0, 64 * P_LOCAL
        ELEN    t0, 12
        SWAP    [t0], sh0, [r0]
        dot_rows ox, oy, oz, sh0, sh1, sh2, sh4, sh5, sh6, sh8, sh9, sh10, own_ox, own_oy, own_oz, t0, t1, t2, t3
        ADDN    own_ox, sh3, own_ox
        ADDN    own_oy, sh7, own_oy
        ADDN    own_oz, sh11, own_oz
        dot_rows dx, dy, dz, sh0, sh1, sh2, sh4, sh5, sh6, sh8, sh9, sh10, own_dx, own_dy, own_dz, t0, t1, t2, t3
        EX      t1, k_lower
        LOD     [t1], own_lower
        normalise own_dx, own_dy, own_dz, t0, own_scale
        EX      t1, own_ray
        ELEN    t1, 7
        MPYS    t0, own_lower, own_lower
        SWAP    [r0], own_ox, [t1]
        EX      t1, own_primitive
        STO     [t1], a_primitive
        IX      a_primitive, 64 * P_INNER
        LOD     [a_primitive], target
        RTOR    link, link_saved
        EX      arguments, own_arguments
        BSAVE   link, [target]
        RTOR    link_saved, link
        EX      t1, own_segment
        ELEN    t1, 2
        SWAP    [t1], tin, [r0]
        CFPLT   tout, tin, transform_missed
        MPYS    tin, own_scale, tin
        MPYS    tout, own_scale, tout
transform_missed:
        leave_kernel transform_save, TRANSFORM_REGISTERS
        .endkernel
