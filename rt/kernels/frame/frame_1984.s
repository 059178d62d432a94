; frame_1984.s - computes a frame as in 1984: only intersections are vectors.
;
; Rays, queues, levels, bounding spheres and kernels are those of the vector
; form. Ray generation, visible surfaces, shading, shadows and spawned rays are
; loops on the scalar unit that call the scalar form's routines. The frame
; equals that of both forms, bit for bit.
; Source: the paper: "the ray/primitive intersections were vectorized".

        .include "frame/records.s"
        .if     ADAPTIVE
        .include "frame/adaptive.s"
        .endif
        .include "frame/queue.s"
        .include "light/power_constants.s"
        .reg    link_walk, r133

        .equ    VALUE_SIZE, 1           ; words of a tree's value

        .entry  frame
        .kernel frame
frame:
        call_routine begin_queues, link_walk
        call_routine begin_scalar, link_kernel
        call_routine trace_levels, link
        .if     ADAPTIVE
        refine_pixels begin_fine, next_fine, average_fine, end_fine, link_kernel
        .else
        call_routine average_1984, link_kernel
        .endif
        EXIT
        .endkernel

        .include "frame/camera.s"
        .include "frame/order.s"
        .include "frame/begin_vector.s"
        .include "frame/intersect_vector.s"
        .include "solids/levels_vector.s"
        .include "solids/invisible_vector.s"

; The register names below are those of the scalar program, which has all
; registers to itself (context_1984.s).
        .include "frame/context_1984.s"
        .share
        .include "frame/linkage.s"
        .include "frame/vectors_scalar.s"
        .include "frame/begin_1984.s"
        .include "frame/forms_scalar.s"
        .if     LENS
        .include "frame/lens.s"
        .endif
        .include "frame/generate.s"
        .include "frame/order_1984.s"
        .include "frame/generate_1984.s"
        .include "frame/bound_scalar.s"
        .include "solids/visible_scalar.s"
        .include "solids/span_scalar.s"
        .include "light/forms_scalar.s"
        .include "light/transmitted_scalar.s"
        .include "frame/nearest_1984.s"
        .include "light/power.s"
        .include "light/pigment_scalar.s"
        .include "light/sky_scalar.s"
        .include "light/surface_scalar.s"
        .include "shapes/normal_scalar.s"
        .include "shapes/every_normal.s"
        .include "light/light.s"
        .include "frame/hits_1984.s"
        .include "light/spawn_scalar.s"
        .include "light/shade_1984.s"
        .include "light/spawn_1984.s"
        .include "light/resolve_1984.s"
        .if     FOG
        .include "light/fog_1984.s"
        .endif
        .include "frame/samples.s"
        .if     ADAPTIVE
        .include "frame/adaptive_scalar.s"
        .include "frame/adaptive_1984.s"
        .else
        .include "frame/average.s"
        .include "frame/average_1984.s"
        .endif
        .endshare
