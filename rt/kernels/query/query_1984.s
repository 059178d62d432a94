; query_1984.s - all visible crossings along rays in kernels mode, as in 1984.
;
; Vector kernels intersect queues of rays with the primitives; the rest is done
; ray by ray. Arguments and results: query.s.
;
; Queues, kernels and bounding spheres are those of the vector form. The visible
; crossings of a tree, the order of crossings and the counts of bodies are loops
; on the scalar unit. The results equal those of both forms, bit for bit.
; Source: the paper: "the ray/primitive intersections were vectorized".

        .equ    VALUE_SIZE, 1           ; words of a tree's value

        .macro  begin_form
        call_routine begin_scalar, link_kernel
        .endm
        .macro  order_crossings
        .endm
        .entry  lines
        .include "query/queue_vector.s"
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
