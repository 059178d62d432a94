; begin_vector.s - prepares the data that all queues share.
;
; It loads constants into registers, computes the camera and fills the vectors
; that never change. Called by link_walk.
        .kernel frame
begin_queues:
        load_words constants, CONSTANTS, one, s0
        load_words power_constants, POWER_CONSTANTS, p_47, s0
        begin_counting
        call_routine camera, link
        load_words view, 3, s1, s0
        store_words s1, 3, queue_origin, s0
        EX      s4, QUEUE
        describe iota, count_store, s4
        INTVLV  r0, one_index, [iota]
        describe s5, queue_store, s4
        EX      s6, 64 * QUEUE
        VTOV    s1, [s5]
        ADDX    s5, s6, s5
        VTOV    s2, [s5]
        ADDX    s5, s6, s5
        VTOV    s3, [s5]
        describe s5, least_store, s4
        VTOV    tmin, [s5]
        describe s5, least_shadow, s4
        load_word k_shadow, s6
        VTOV    s6, [s5]
        describe s5, importance_one, s4
        VTOV    one, [s5]
        .if     INTERIORS
        describe s5, inside_unknown, s4
        VTOV    minus_one, [s5]
        .endif
        .if     HIDDEN
        describe s5, class_image, s4
        ES      s6, IMAGE_RAYS
        VTOV    s6, [s5]
        .endif
        call_routine begin_order, link
        BIM     0, link_walk
        .endkernel
