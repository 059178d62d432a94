; query_1984.s - all visible crossings along rays in kernels mode, as in 1984.
;
; Vector kernels intersect queues of rays with the primitives; the rest is done
; ray by ray. Arguments and results: query.s.
;
; Queues, kernels and bounding spheres are those of the vector form. The visible
; crossings of a tree, the order of crossings and the counts of bodies are loops
; on the scalar unit. The results equal those of both forms, bit for bit.
; Source: the paper: "the ray/primitive intersections were vectorized".

        .include "frame/records.s"
        .include "frame/queue.s"
        .include "query/query.s"
        .reg    link_walk, r133

        .equ    VALUE_SIZE, 1           ; words of a tree's value

        .include "query/queue_vector.s"

        .entry  lines
        .kernel lines
lines:
        begin_machine
        begin_queues
        call_routine begin_scalar, link_kernel
query_next:
        begin_queue
        call_routine walk_regions, link
        .if     DEPTHS
        call_routine count_depths, link_kernel
        .endif
        next_queue
        .endkernel

        .include "frame/intersect_vector.s"
        .include "solids/invisible_vector.s"

; From here on registers have the names of the scalar program.
        .include "frame/context_1984.s"
        .share
        .include "frame/linkage.s"
        .include "frame/vectors_scalar.s"
        .include "frame/begin_1984.s"
        .include "frame/bound_scalar.s"
        .include "solids/visible_scalar.s"
        .include "solids/span_scalar.s"
        .include "light/pigment_scalar.s"
        .include "light/surface_scalar.s"
        .include "shapes/normal_scalar.s"
        .include "shapes/every_normal.s"
        .include "query/crossing_scalar.s"
        .include "query/ray_hits_1984.s"
        .if     DEPTHS
        .include "query/depth_scalar.s"
        .include "query/depth_1984.s"
        .endif
        .endshare
