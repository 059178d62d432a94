; frame_vector.s - computes a frame in queues: the vector form of the tracer.
;
; The host requests a band of rows of the frame. For each queue of QUEUE rays
; (the last may be shorter), the program generates the rays, finds the nearest
; hits and shades them. Reflected and refracted rays are appended to the list of
; the next level (levels_vector.s). The host fills the scene (records.s) before
; and reads the planes of the band afterwards.

        .include "frame/records.s"
        .if     ADAPTIVE
        .include "frame/adaptive.s"
        .endif
        .include "frame/queue.s"
        .include "light/power_constants.s"
; pairs_vector.s: number of pairs that are processed together, and the largest
; set of rays that is turned into pairs.
        .if     QUEUE < 512
        .equ    PAIRS, 64
        .equ    PAIR_SET, 16
        .else
        .equ    PAIRS, 2048
        .equ    PAIR_SET, 64
        .endif
        .reg    link_walk, r133

; Words of a tree's values before and after an event.
        .equ    VALUE_SIZE, 2 * QUEUE_BIT_WORDS

        .entry  frame
        .kernel frame
frame:
        call_routine begin_queues, link_walk
        call_routine blank_planes, link
        call_routine trace_levels, link
        .if     ADAPTIVE
        refine_pixels fine_begin, fine_next, fine_average, fine_end, link
        .else
        call_routine average, link
        .endif
        EXIT
        .endkernel

        .include "frame/camera.s"
        .include "frame/order.s"
        .include "frame/begin_vector.s"
        .include "frame/intersect_vector.s"
        .include "frame/nearest_vector.s"
        .include "frame/pairs_vector.s"
        .include "solids/span_vector.s"
        .include "solids/visible_vector.s"
        .include "solids/visible_every_vector.s"
        .include "solids/levels_vector.s"
        .include "light/resolve_vector.s"
        .include "shapes/normal_vector.s"
        .include "frame/forms_vector.s"
        .if     LENS
        .include "frame/lens.s"
        .endif
        .if     ADAPTIVE
        .include "frame/places.s"
        .endif
        .include "frame/generate.s"
        .include "frame/order_vector.s"
        .include "shapes/every_normal.s"
        .include "light/forms_vector.s"
        .include "light/shade_vector.s"
        .include "light/pigment_vector.s"
        .include "light/light_vector.s"
        .include "light/shadow_vector.s"
        .include "light/spawn_vector.s"
        .if     INTERIORS
        .include "light/interior.s"
        .include "light/interior_vector.s"
        .endif
        .include "light/power.s"
        .include "frame/samples.s"
        .if     ADAPTIVE
        .include "frame/adaptive_vector.s"
        .else
        .include "frame/average.s"
        .endif
        .include "solids/invisible_vector.s"
        .if     PATTERNS
        .include "light/pattern.s"
        .endif
        .if     IMAGES
        .include "light/image.s"
        .endif
        .include "light/routines_vector.s"
        .data
        .include "light/sky.s"
        .code
