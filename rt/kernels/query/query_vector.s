; query_vector.s - all visible crossings along rays: the vector form.
;
; Arguments and results: query.s. In each region, the search steps along the
; crossings of each ray to its end (visible_vector.s). Each visible crossing is
; scattered to the planes when it is found, after the crossings that its ray
; has (ray_hits_vector.s). After all regions the planes of the queue are sorted
; (sort_vector.s).

        .macro  begin_form
        EX      found, found_crossings
        .endm
        .macro  order_crossings
        call_routine sort_crossings, link_kernel
        .endm
        .entry  lines
        .include "query/queue_vector.s"

; Words of a tree's values before and after an event.
        .equ    VALUE_SIZE, 2 * QUEUE_BIT_WORDS

        .include "frame/intersect_vector.s"
        .include "frame/nearest_vector.s"
        .include "solids/span_vector.s"
        .include "solids/visible_vector.s"
        .include "solids/visible_every_vector.s"
        .include "light/hits_vector.s"
        .include "shapes/normal_vector.s"
        .include "shapes/every_normal.s"
        .include "light/surface_vector.s"
        .include "query/ray_hits_vector.s"
        .include "query/sort_vector.s"
        .if     DEPTHS
        .include "query/depth_vector.s"
        .endif
        .include "solids/invisible_vector.s"
