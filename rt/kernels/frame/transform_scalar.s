; transform_scalar.s - intersects a primitive in its object space.
;
;       CALL TRANSFORMED (RAY, PRIMITIVE, SEGMENT)
;
; Arguments as in sphere_scalar.s, method as in transform_vector.s. The ray and
; its least distance are transformed into local_ray. The kernel for object
; space, whose address is in inner, is called with this ray. The length of
; SEGMENT is the number of crossings. For neighbouring primitives in one space,
; the ray is transformed once. The caller clears local_space for each new ray.

        .share  local
        .regs   r68, local_ox, local_oy, local_oz, local_dx, local_dy, local_dz
        .regs   r74, local_lower, local_scale, link_saved
        .endshare
        shape_from r56                  ; rows of the matrix, after t7
        .equ    TRANSFORM_REGISTERS, 45

        .data
transform_save: .space TRANSFORM_REGISTERS
local_ray:      .space 8                ; the last word is 1/s
local_space:    .word 0                 ; number of the ray's space; 0: none yet
local_segment:  .space MAX_CROSSINGS
local_arguments:
        .descriptor 6, local_ray
        .word 0
        .descriptor 2, local_segment

        .code
        .kernel transform
transformed:
        enter   kernel_image, KERNEL_CONSTANTS, transform_save, TRANSFORM_REGISTERS
        load_from arguments, 3, a_ray
        load_of a_primitive, P_SPACE, t4
        EX      t5, local_space
        LOD     [t5], t6
        EX      t7, local_ray
        ELEN    t7, 8
        IBXEQ   t4, r0, t6, transform_shifted
        STO     [t5], t4
        SWAP    [a_ray], ox, [r0]
        load_part a_primitive, P_LOCAL, 12, sh0, t0
        dot_rows ox, oy, oz, sh0, sh1, sh2, sh4, sh5, sh6, sh8, sh9, sh10, local_ox, local_oy, local_oz, t0, t1, t2, t3
        ADDN    local_ox, sh3, local_ox
        ADDN    local_oy, sh7, local_oy
        ADDN    local_oz, sh11, local_oz
        dot_rows dx, dy, dz, sh0, sh1, sh2, sh4, sh5, sh6, sh8, sh9, sh10, local_dx, local_dy, local_dz, t0, t1, t2, t3
        ES      t1, 7
        LOD     [a_ray, t1], local_lower
        normalise_by one, local_dx, local_dy, local_dz, t0, local_scale
        MPYS    t0, local_lower, local_lower
        SWAP    [r0], local_ox, [t7]
        BIM     transform_call
transform_shifted:
        ES      t1, 7
        LOD     [t7, t1], local_scale
transform_call:
        EX      arguments, local_arguments
        STO     [arguments, index_one], a_primitive
        RTOR    link, link_saved
        RTOR    inner, target
        BSAVE   link, [target]
        RTOR    link_saved, link
        LTOR    a_segment, t2
        EX      t1, local_segment
transform_next:
        LOD     [t1], tin
        LOD     [t1, index_one], tout
        ABS     tin, t3
        ABS     tout, t4
        CFPGE   t3, big, transform_leave
        MPYS    tin, local_scale, tin
transform_leave:
        CFPGE   t4, big, transform_store
        MPYS    tout, local_scale, tout
transform_store:
        STO     [a_segment], tin
        STO     [a_segment, index_one], tout
        IX      t1, 64 * 2
        IX      a_segment, 64 * 2
        IX      t2, -2
        IBXGT   t2, r0, r0, transform_next
        leave   transform_save, TRANSFORM_REGISTERS
        .endkernel
