; frame_vector.s - a frame, queue by queue: the vector form of the tracer.
;
; For each queue of QUEUE rays (the last may be shorter): make the rays, find
; what each of them meets first, shade.  The host has filled the scene
; (records.s) and reads the frame's planes afterwards.

        .include "records.s"
        .include "queue.s"
        .include "power_constants.s"
        .regs   r194, plane_at, plane_size

        .entry  frame
        .kernel frame
frame:
        EX      s0, constants
        ELEN    s0, CONSTANTS
        SWAP    [s0], one, [r0]
        EX      s0, power_constants
        ELEN    s0, POWER_CONSTANTS
        SWAP    [s0], p_fraction, [r0]
        SUBN    r0, one, minus_one
        ES      one_index, 1
        ES      minus_one_index, -1
        EX      target, camera
        BSAVE   link, [target]
        EX      s0, view
        ELEN    s0, VIEW_SIZE
        SWAP    [s0], viewlx, [r0]
        EX      s0, scene_width
        LOD     [s0], width
        EX      s0, scene_pixels
        LOD     [s0], pixels
        ES      pixel, 0
        EX      s0, shade_bases
        LOD     [s0], at
        EX      n, QUEUE
        set_lengths n, n_high, queue_bases, queue_descriptors, QUEUE_VECTORS, hit_s
        INTVLV  pixel, one_index, [iota]
        VTOV    tmin, [wlower]
frame_next:
        SUBX    pixels, pixel, batch
        EX      s2, QUEUE
        IBXLE   batch, r0, s2, frame_short
        RTOR    s2, batch
frame_short:
        IBXEQ   batch, r0, n, frame_lengths
        RTOR    batch, n
        set_lengths n, n_high, queue_bases, queue_descriptors, QUEUE_VECTORS, hit_s
frame_lengths:
        EX      s0, scene_frame
        LOD     [s0], plane_at
        SHIFTI  pixel, 6, s0
        ADDX    plane_at, s0, plane_at
        ADDLEN  plane_at, n, plane_at
        SHIFTI  pixels, 6, plane_size
        RTOR    plane_at, out_red
        ADDX    out_red, plane_size, out_green
        ADDX    out_green, plane_size, out_blue
        ADDX    out_blue, plane_size, out_depth
        ADDX    out_depth, plane_size, out_nx
        ADDX    out_nx, plane_size, out_ny
        ADDX    out_ny, plane_size, out_nz
        ADDX    out_nz, plane_size, out_id
        EX      target, generate
        BSAVE   link, [target]
        EX      target, find_nearest
        BSAVE   link, [target]
        EX      target, shade
        BSAVE   link, [target]
        ADDX    pixel, n, pixel
        IBXLT   pixel, r0, pixels, frame_next
        EXIT
        .endkernel

        .include "camera.s"
        .include "generate_vector.s"
        .include "slab_vector.s"
        .include "sphere_vector.s"
        .include "box_vector.s"
        .include "quadratic_vector.s"
        .include "cylinder_vector.s"
        .include "cone_vector.s"
        .include "quadric_vector.s"
        .include "plane_vector.s"
        .include "quartic_vector.s"
        .include "lanes_vector.s"
        .include "torus_vector.s"
        .include "quartic_terms.s"
        .include "quartic_surface_vector.s"
        .include "steiner_constants.s"
        .include "steiner_vector.s"
        .ifdef  HISTORICAL
        .include "steiner_implicit_vector.s"
        .endif
        .include "transform_vector.s"
        .include "nearest_vector.s"
        .include "normal_vector.s"
        .include "normal_quadric_vector.s"
        .include "normal_quartic_vector.s"
        .include "shade_vector.s"
        .include "power_vector.s"
