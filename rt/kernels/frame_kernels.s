; frame_kernels.s - a frame as in 1984: queues of rays are met with the
; primitives by vector kernels, all else is done ray by ray.
;
; Rays, queues, levels and kernels are those of the vector form, with bounding
; spheres; making rays, what is visible, shading, shadows and new rays are loops
; on the scalar unit over the scalar form's routines.  So the frame is that of
; both, bit for bit.
; Source: the paper: "the ray/primitive intersections were vectorized".

        .include "records.s"
        .include "queue.s"
        .include "power_constants.s"
        .reg    link_walk, r133

        .equ    VALUE_SIZE, 1           ; of a tree's, in words

        .entry  frame
        .kernel frame
frame:
        EX      target, begin_queues
        BSAVE   link_walk, [target]
        EX      target, begin_scalar
        BSAVE   link_kernel, [target]
        EX      target, trace_levels
        BSAVE   link, [target]
        EXIT
        .endkernel

        .include "camera.s"
        .include "begin_vector.s"
        .include "intersect_vector.s"
        .include "levels_vector.s"

; From here on registers have the names of the scalar program.
        .include "context_kernels.s"
        .include "linkage.s"
        .include "vectors_scalar.s"
        .include "begin_kernels.s"
        .include "generate_scalar.s"
        .include "generate_kernels.s"
        .include "bound_scalar.s"
        .include "visible_scalar.s"
        .include "span_scalar.s"
        .include "passing_scalar.s"
        .include "nearest_kernels.s"
        .include "power_scalar.s"
        .include "pigment_scalar.s"
        .include "surface_scalar.s"
        .include "normal_scalar.s"
        .include "normal_quadric_scalar.s"
        .include "normal_quartic_scalar.s"
        .include "light_scalar.s"
        .include "hits_kernels.s"
        .include "spawn_scalar.s"
        .include "shade_kernels.s"
        .include "spawn_kernels.s"
        .include "resolve_kernels.s"
