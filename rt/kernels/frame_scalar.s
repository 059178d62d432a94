; frame_scalar.s - a frame, ray by ray: the scalar form of the tracer.
;
; For each pixel: make its ray, call each primitive's kernel with it, keep the
; nearest hit, shade.  The same operations in the same order as the vector
; form, so that both give the same frame bit for bit.

        .include "records.s"
        .include "linkage.s"
        .include "power_constants.s"

; The main program's registers.
        .regs   r12, column, row, width, primitive, primitives_left, plane_at
        .regs   r18, m_one, m_half, m_two, m_big, m_minus_big, m_tiny, m_tmin
        .regs   r25, m_checker_shift
        .regs   r26, m_minus_one, m_index_one, m_index_minus_one, m_zero
        .regs   r30, plane_size, height
        .regs   r240, hit_primitive, nearest, main_at, main_t, segment_in
        .regs   r245, segment_out
        .regs   r246, sample_r, sample_g, sample_b, sample_nx, sample_ny
        .regs   r251, sample_nz, hit_id

        .data
ray:            .space 7        ; O, D, and tmin: the least distance
pixel:          .space 2
segment:        .space 2
distance:       .space 1
sample:         .space 6
generate_list:  .descriptor 2, pixel
                .descriptor VIEW_SIZE, view
                .descriptor 6, ray
kernel_list:    .descriptor 6, ray
kernel_primitive: .word 0
                .descriptor 2, segment
shade_list:     .descriptor 6, ray
shade_primitive: .word 0
                .descriptor 1, distance
                .descriptor 6, sample
        .code

        .macro  load_at label, number, first
        EX      main_at, \label
        ELEN    main_at, \number
        SWAP    [main_at], \first, [r0]
        .endm

        .macro  store_sample word
        STO     [main_at], \word
        ADDX    main_at, plane_size, main_at
        .endm

        .entry  frame
        .kernel frame
frame:
        load_at constants, CONSTANTS, m_one
        load_at power_constants, POWER_CONSTANTS, p_fraction
        EX      main_at, ray
        IX      main_at, 64 * 6
        STO     [main_at], m_tmin
        SUBN    r0, m_one, m_minus_one
        ES      m_index_one, 1
        ES      m_index_minus_one, -1
        ADDN    r0, r0, m_zero
        EX      target, camera
        BSAVE   link, [target]
        load_at scene_width, 2, sample_r
        RTOR    sample_r, width
        RTOR    sample_g, height
        EX      main_at, scene_pixels
        LOD     [main_at], plane_size
        SHIFTI  plane_size, 6, plane_size
        EX      main_at, scene_frame
        LOD     [main_at], plane_at
        RTOR    m_zero, row
frame_row:
        RTOR    m_zero, column
frame_pixel:
        EX      main_at, pixel
        STO     [main_at], column
        STO     [main_at, m_index_one], row
        call    generate, generate_list
        .endkernel

        .kernel nearest
        RTOR    m_big, nearest
        ES      hit_primitive, 0
        EX      main_at, scene_primitives
        LOD     [main_at], primitive
        EX      main_at, scene_primitive_count
        LOD     [main_at], primitives_left
        IBXEQ   primitives_left, r0, r0, nearest_done
nearest_next:
        .endkernel
        .kernel call
        EX      main_at, kernel_primitive
        STO     [main_at], primitive
        LOD     [primitive], target
        EX      arguments, kernel_list
        BSAVE   link, [target]
        load_at segment, 2, segment_in
        .endkernel
        .kernel nearest
        CFPLT   m_tmin, segment_in, nearest_ahead
        RTOR    segment_out, segment_in
        CFPGE   m_tmin, segment_in, nearest_skip
nearest_ahead:
        CFPGE   segment_in, nearest, nearest_skip
        RTOR    segment_in, nearest
        RTOR    primitive, hit_primitive
nearest_skip:
        IX      primitive, 64 * P_SIZE
        IBXNE   primitives_left, m_index_minus_one, r0, nearest_next, primitives_left
nearest_done:
        .endkernel

        .kernel shade
        IBXEQ   hit_primitive, r0, r0, frame_background
        EX      main_at, shade_primitive
        STO     [main_at], hit_primitive
        EX      main_at, distance
        STO     [main_at], nearest
        call    shade, shade_list
        load_at sample, 6, sample_r
        IX      hit_primitive, 64 * P_ID
        LOD     [hit_primitive], hit_id
        BIM     frame_store
frame_background:
        load_at scene_background, 3, sample_r
        RTOR    m_zero, nearest
        RTOR    m_zero, sample_nx
        RTOR    m_zero, sample_ny
        RTOR    m_zero, sample_nz
        RTOR    m_zero, hit_id
        .endkernel

        .kernel frame
frame_store:
        RTOR    plane_at, main_at
        store_sample sample_r
        store_sample sample_g
        store_sample sample_b
        store_sample nearest
        store_sample sample_nx
        store_sample sample_ny
        store_sample sample_nz
        store_sample hit_id
        IX      plane_at, 64
        ADDN    column, m_one, column
        CFPLT   column, width, frame_pixel
        ADDN    row, m_one, row
        CFPLT   row, height, frame_row
        EXIT
        .endkernel

        .include "camera.s"
        .include "generate_scalar.s"
        .include "slab_scalar.s"
        .include "sphere_scalar.s"
        .include "box_scalar.s"
        .include "quadratic_scalar.s"
        .include "cylinder_scalar.s"
        .include "cone_scalar.s"
        .include "quadric_scalar.s"
        .include "plane_scalar.s"
        .include "quartic_scalar.s"
        .include "lanes_scalar.s"
        .include "torus_scalar.s"
        .include "quartic_terms.s"
        .include "quartic_surface_scalar.s"
        .include "steiner_constants.s"
        .include "steiner_scalar.s"
        .ifdef  HISTORICAL
        .include "steiner_implicit_scalar.s"
        .endif
        .include "transform_scalar.s"
        .include "power_scalar.s"
        .include "shade_scalar.s"
        .include "normal_scalar.s"
        .include "normal_quadric_scalar.s"
        .include "normal_quartic_scalar.s"
