; query_1984.s - all that is seen along lines as in 1984: queues of lines are met with the
; primitives by vector kernels, all else is done line by line; query.s says what goes in
; and comes out.
;
; Queues, kernels and bounding spheres are those of the vector form; what is seen of a
; tree, the order of crossings and counts of bodies are loops on the scalar unit.  So what
; is found is that of both, bit for bit.
; Source: the paper: "the ray/primitive intersections were vectorized".

        .include "frame/records.s"
        .include "frame/queue.s"
        .include "query/query.s"
        .reg    link_walk, r133

        .equ    VALUE_SIZE, 1           ; of a tree's, in words

        .include "query/queue_vector.s"

        .entry  lines
        .kernel lines
lines:
        begin_machine
        begin_queues
        EX      target, begin_scalar
        BSAVE   link_kernel, [target]
lines_next:
        begin_queue
        EX      target, walk_regions
        BSAVE   link, [target]
        .if     BODIES
        EX      target, count_bodies
        BSAVE   link_kernel, [target]
        .endif
        next_queue
        .endkernel

        .include "frame/intersect_vector.s"
        .include "solids/unseen_vector.s"

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
        .include "shapes/every_normal_scalar.s"
        .include "query/crossing_scalar.s"
        .include "query/seen_1984.s"
        .if     BODIES
        .include "query/depth_scalar.s"
        .include "query/depth_1984.s"
        .endif
        .endshare
