; frame_vector.s - a frame, queue by queue: the vector form of the tracer.
;
; The host asks for a band of the frame, some of its rows.  For each queue of
; QUEUE rays (the last may be shorter): make the rays, find what each of them
; meets first, shade; what is reflected and refracted makes rays of the next
; level, and so on (levels_vector.s).  The host has filled the scene (records.s)
; and reads the band's planes afterwards.

        .include "records.s"
        .include "queue.s"
        .include "power_constants.s"
        .reg    link_walk, r133

        .entry  frame
        .kernel frame
frame:
        EX      target, begin_queues
        BSAVE   link_walk, [target]
        EX      target, trace_levels
        BSAVE   link, [target]
        EXIT
        .endkernel

        .include "camera.s"
        .include "begin_vector.s"
        .include "intersect_vector.s"
        .include "nearest_vector.s"
        .include "span_vector.s"
        .include "visible_vector.s"
        .include "visible_every_vector.s"
        .include "levels_vector.s"
        .include "resolve_vector.s"
        .include "generate_vector.s"
        .include "normal_vector.s"
        .include "normal_quadric_vector.s"
        .include "normal_quartic_vector.s"
        .include "shade_vector.s"
        .include "pigment_vector.s"
        .include "light_vector.s"
        .include "shadow_vector.s"
        .include "spawn_vector.s"
        .include "power_vector.s"
